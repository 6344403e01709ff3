// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What this program can compare: descriptions of problems and optimizers, filled by explicit calls, no static objects.
///
/// Each component folder has one function `void register_<folder>(Registry&)`; the build collects them.
///
/// Threads  fill it first, then share it.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/command.h>
#include <nodal/dense_matrix.h>
#include <nodal/exhibit.h>
#include <nodal/input_files.h>
#include <nodal/optimizer.h>
#include <nodal/options.h>
#include <nodal/problem.h>
#include <nodal/result_cache.h>

namespace nodal {

/// That a method is a choice for a problem when nobody names one: `nodal fit` takes the highest rank.
struct Suitability {
  int rank = 0;  ///< 0 for a method of last resort; above it, the more is known about what it does here
  std::string reason;
};

struct OptimizerDescription {
  std::string name = {};       ///< as `use` names it, e.g. "nlopt-crs2-lm"
  std::string summary = {};    ///< one line
  std::string reference = {};  ///< where the method is described
  Abilities needs = {};
  bool deterministic = false;  ///< draws nothing from the stream
  bool uses_start = true;      ///< false for methods that search the whole box regardless: no use in multi-start
  bool local = false;          ///< goes to a nearby minimum
  DenseMatrix dense_matrix = DenseMatrix::none;  ///< the largest that it holds
  OptionSchema options = {};
  std::function<std::unique_ptr<Optimizer>(const Options&)> make = {};
  /// Of a problem that gives what the method needs; empty when it shouldn't be taken unasked. Left out: never.
  std::function<std::optional<Suitability>(const Problem&)> suits = {};
};

/// Where a problem of a study stands, and its files.
struct ProblemContext {
  InputFiles& files;
  Source source;
  ResultCache cache = {};  ///< for what takes long to make of the problem's inputs
};

/// A problem of a kind that tests and examples may take: small, made in no time.
struct ProblemSample {
  std::string name = {};      ///< to tell samples of a kind apart; empty for that of the defaults
  std::string settings = {};  ///< further lines of [problem], TOML
};

struct ProblemDescription {
  std::string kind = {};  ///< as `kind` names it, e.g. "elastic"
  std::string summary = {};
  std::string reference = {};
  OptionSchema options = {};  ///< beside kind, label and best_known, which the study itself knows
  /// InputError (with the source of the value at fault) for options that are each valid but don't make a problem.
  std::function<std::shared_ptr<const Problem>(const Options&, const ProblemContext&)> make = {};

  // How its results are told, where problems are not built: of stores that anybody may have written.

  std::string quality_name = "quality";  ///< what its quality is called: "G"; the best known is "G*"
  std::string quality_help = "what people read of the cost: smaller is better";
  std::vector<FindingDescription> findings = {};
  /// From a manifest's "details" (Problem::details), of whatever build. Left out: nothing is said of them.
  std::function<ReportPart(const Value& details)> show_details = {};
  /// Why a problem by this table of a study would take too long to be built for its pictures alone. Empty, or left out:
  /// it wouldn't.
  std::function<std::string(const Value& table)> too_costly_to_draw = {};

  std::vector<Command> commands = {};
  std::vector<Listing> listings = {};
  std::vector<ProblemSample> samples = {ProblemSample{}};  ///< for tests; the defaults at least
};

/// Something that this build lacks, and how to get it. `name` is a whole name, or a prefix when it ends with '*'.
struct AbsentDescription {
  std::string name = {};
  std::string reason = {};
};

class Registry {
 public:
  /// std::logic_error when the name is taken.
  void add(OptimizerDescription description);
  void add(ProblemDescription description);
  void add(AbsentDescription description);

  [[nodiscard]] const OptimizerDescription* find_optimizer(std::string_view name) const;
  [[nodiscard]] const ProblemDescription* find_problem(std::string_view kind) const;
  /// Why `name` isn't here, when that is known.
  [[nodiscard]] const AbsentDescription* find_absent(std::string_view name) const;

  // In the order in which they were added.
  [[nodiscard]] const std::vector<OptimizerDescription>& optimizers() const noexcept { return optimizers_; }
  [[nodiscard]] const std::vector<ProblemDescription>& problems() const noexcept { return problems_; }
  [[nodiscard]] const std::vector<AbsentDescription>& absent() const noexcept { return absent_; }

 private:
  std::vector<OptimizerDescription> optimizers_;
  std::vector<ProblemDescription> problems_;
  std::vector<AbsentDescription> absent_;
};

}  // namespace nodal
