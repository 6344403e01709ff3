// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A study: which optimizers race on which problems, with what budget, how often. Read from a TOML file
/// (docs/config_reference.md has every key), complete and validated: what can be wrong is found here, not in a trial.
///
/// Threads  immutable after reading; problems are shared.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/registry.h>

namespace nodal {

enum class Starts { initial, sampled };

struct Budget {
  std::optional<double> seconds;  ///< wall time per trial [s]
  std::optional<std::int64_t> evaluations;
  std::optional<double> target_gap;  ///< stop when (G − G*)/(G_start − G*) ≤ this; needs a best known quality
  /// A validated stop (unseen.h): what is held out chooses the point that is reported. Each problem holds out two
  /// things at least.
  bool validated = false;
};

struct StudyProblem {
  std::string label;
  std::string kind;
  Options options;
  std::shared_ptr<const Problem> problem;  ///< built once, when the study is read
  std::optional<KnownOptimum> best_known;  ///< the study's, else the problem's own
  /// Of the files that it was read from (InputFiles::fingerprint): part of every trial's key, so that a changed file
  /// makes new trials. Empty when options say it all.
  std::string fingerprint = {};
  bool skipped = false;  ///< by `only_problems`: not run, but what is stored of it stays in the report
};

struct StudyOptimizer {
  std::string label;
  std::string use;
  Options options;
  bool baseline = false;
  bool multi_start = false;
  bool deterministic = false;  ///< the method's own, false under multi-start
  bool skipped = false;        ///< by `only`: not run, but what is stored of it stays in the report
};

/// An optimizer of the study that this build lacks: left out of the race, and said.
struct LeftOut {
  std::string label;
  std::string use;
  std::string reason;
};

/// A file that a study includes, as it was read.
struct IncludedFile {
  std::filesystem::path path;
  std::string text;
};

struct Study {
  std::string name;
  std::uint64_t seed = 1;
  int repeats = 15;
  Starts starts = Starts::initial;
  Budget budget;
  std::vector<StudyProblem> problems;
  std::vector<StudyOptimizer> optimizers;
  std::vector<LeftOut> left_out;
  std::string text;  ///< the file as it was read
  std::filesystem::path path;
  std::vector<IncludedFile> included = {};  ///< what it is joined with, in the order of reading
  /// What the command line set in it, seed, repeats and budget as well: with these as StudyOverrides::set the text has
  /// the same trials.
  std::vector<std::string> settings = {};
};

/// What a command line may change of a study.
struct StudyOverrides {
  std::optional<double> seconds;
  std::optional<std::int64_t> evaluations;
  std::optional<std::uint64_t> seed;
  std::optional<int> repeats;
  std::vector<std::string> only;                ///< labels, or a `use` that one entry has; several separated by commas
  std::vector<std::string> only_problems = {};  ///< their labels
  std::vector<std::string> set = {};  ///< "problem.material.poisson=0.2": any key, after what is included; see --set
  /// Texts of what the study includes, in the order of reading, instead of the files: those that a store has.
  std::optional<std::vector<IncludedFile>> included = {};
  /// `best_known = { file = … }` isn't read, and nobody knows that quality, unless trials are to end near it: a fit may
  /// be what writes the file.
  bool without_best_known_files = false;
  /// Where a study of this name keeps what takes long to make (result_cache.h); nowhere without it.
  std::function<std::filesystem::path(const std::string& study)> cache = {};
};

/// Reads a study. InputError ("file:line: …") for everything that is wrong with it: syntax, an unknown key, type,
/// range, an unknown optimizer or problem (nearest names offered), two equal labels, an optimizer that needs what a
/// problem can't give, or whose dense matrix is too large for it (dense_matrix.h). A study without optimizers or
/// without a budget can be evaluated, but not compared.
[[nodiscard]] Study read_study(const std::filesystem::path& path, const Registry& registry,
                               const StudyOverrides& overrides = {});
/// The same from a text; `path` is for messages and relative files.
[[nodiscard]] Study parse_study(std::string_view text, const std::filesystem::path& path, const Registry& registry,
                                const StudyOverrides& overrides = {});

/// The tables that a study comes to before anything is made of them: with what it includes and what is set, a problem
/// with ranges as one for each combination. For those who look before they let a study be read. InputError.
[[nodiscard]] Value study_tables(std::string_view text, const std::filesystem::path& path,
                                 const StudyOverrides& overrides = {});

/// The keys of [study], [budget], [problem] and [[optimizer]] that the study itself knows, for the config reference.
[[nodiscard]] OptionSchema study_schema();
[[nodiscard]] OptionSchema budget_schema();
[[nodiscard]] OptionSchema problem_entry_schema();
[[nodiscard]] OptionSchema optimizer_entry_schema();

}  // namespace nodal
