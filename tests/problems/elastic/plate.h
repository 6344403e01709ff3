// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The plate of the tests: the elastic problem's defaults, with a few options changed by a line of TOML-like settings.

#include <memory>
#include <string>

#include <nodal/elastic/elastic_problem.h>
#include <nodal/study.h>

#include "../../support/components.h"

namespace nodal::elastic {

/// Options of a plate, with DESIGN's 25-node plate as default.
struct PlateOptions {
  double poisson = 0.3;
  std::string plane = "stress";
  std::string parameters = "each";
  std::string initial = "\"paper\"";
  std::string supports = "edge";
  std::string topology = "crossed";
  std::string bounds = "[1e-4, 1e2]";
  std::string counts = "[5, 5]";
  std::string size = "[4.0, 4.0]";
  double stress = 1.0;
  double young = 1.0;
  std::string solver = "auto";
  std::string moves = "auto";
  std::string instructions = "auto";
  std::string more = "";  ///< lines after those of [problem]
};

inline std::string plate_toml(const PlateOptions& o) {
  const auto number = [](double x) { return to_json(Value(x)); };
  return "[problem]\nkind = \"elastic\"\nbody = { shape = \"rectangle\", size = " + o.size +
         ", thickness = 1.0 }\nmaterial = { young = " + number(o.young) + ", poisson = " + number(o.poisson) +
         ", plane = \"" + o.plane + "\" }\npoints = { layout = \"grid\", counts = " + o.counts +
         " }\nsprings = { topology = \"" + o.topology + "\", parameters = \"" + o.parameters +
         "\", initial = " + o.initial + ", bounds = " + o.bounds +
         " }\nloads = { set = \"plate\", stress = " + number(o.stress) + ", supports = \"" + o.supports +
         "\" }\nquality = { weights = { inner = 1, border = 3, corner = 15 } }\nequilibrium = { method = \"" +
         o.solver + "\" }\nmoves = { form = \"" + o.moves + "\", instructions = \"" + o.instructions + "\" }\n" +
         o.more;
}

inline std::shared_ptr<const ElasticProblem> as_elastic(const Study& study) {
  return std::dynamic_pointer_cast<const ElasticProblem>(study.problems.at(0).problem);
}

/// By the lines of [problem] beside its kind.
inline std::shared_ptr<const ElasticProblem> read(const std::string& problem) {
  return as_elastic(parse_study("[problem]\nkind = \"elastic\"\n" + problem, "study.toml", components()));
}

inline std::shared_ptr<const ElasticProblem> make_plate(const PlateOptions& options = {}) {
  return as_elastic(parse_study("[study]\nname = \"plate\"\n" + plate_toml(options), "plate.toml", components()));
}

/// G at the start, refined.
inline double start_quality(const ElasticProblem& problem) {
  const auto evaluator = problem.make_evaluator();
  const Evaluation at_start = evaluator->audit(problem.space().start());
  return at_start.ok() ? problem.quality(at_start.cost) : -1.0;
}

}  // namespace nodal::elastic
