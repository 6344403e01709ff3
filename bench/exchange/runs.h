// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Stored trials in the words that other benchmarks' formats share: functions, dimensions, instances, precisions.
///
///     function   a problem of the study, numbered from 1 in the manifest's order
///     dimension  its coordinates
///     instance   a repeat, numbered from 1: a start, or the drawing of random numbers from one start
///     precision  G − G*, of the quality that was raced; 0 where it is below
///     evaluation numbered from 1, which is the start. A trial looks at its start before the method runs, so the
///                method's first evaluation is 2 here and the number of all is one more than in our own tables.
///
/// G* is the best known quality; that of a trial where one beat it, or where none is known, which is said.

#include <cstdint>
#include <string>
#include <vector>

#include <nodal/merge.h>

namespace nodal::exchange {

/// An improvement, or the last evaluation of a run.
struct RunPoint {
  std::int64_t evaluation = 1;
  double precision = 0.0, quality = 0.0;
  double seconds = 0.0;
  std::int64_t factorizations = 0;
};

struct Run {
  int instance = 1;
  std::int64_t evaluations = 1;  ///< of the whole run
  double seconds = 0.0;          ///< of the whole run
  std::vector<RunPoint> points;  ///< one at least; the first at evaluation 1, evaluations rise, precisions fall
  std::vector<double> x;         ///< the reported best point; empty where there is none
};

/// What both formats write for a quality that is not known: COCO's stand-in for infinity.
inline constexpr double kUnknown = 3e21;

/// The runs of one algorithm on one function.
struct Function {
  int id = 1;
  std::string name;  ///< label of the problem
  std::size_t dimension = 1;
  double best_quality = 0.0;
  bool provisional = false;  ///< best of these trials
  std::vector<Run> runs;     ///< by instance
};

struct Algorithm {
  std::string name;    ///< label of the optimizer
  std::string method;  ///< its `use`
  std::string folder;  ///< a name of its own among the algorithms that any file system takes
  std::vector<Function> functions;
};

struct Experiment {
  std::vector<Algorithm> algorithms;  ///< in the manifest's order, those with a run
  std::vector<std::string> warnings;  ///< what is not as in our own tables, for people
};

/// The trials that the stores' studies ask for.
[[nodiscard]] Experiment make_experiment(const MergedStores& stores);

/// A label with nothing but letters, digits, '.', '-' and '_', for names of files and folders.
[[nodiscard]] std::string file_name_of(const std::string& label);

}  // namespace nodal::exchange
