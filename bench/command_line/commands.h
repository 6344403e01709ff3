// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What each command of the program's own is told, and the command itself, which returns the exit code. How words
/// become arguments is command_line.cpp's business; InputError and StoreError end there too.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nodal/registry.h>
#include <nodal/study.h>

namespace nodal {

struct CompareArguments {
  std::string study, out;  ///< without `out`: results/<name of the study>
  int jobs = 1;
  std::vector<std::string> rerun;  ///< as CompareOptions has them
  bool fresh = false;
  int time_lane = 3;          ///< as CompareOptions has it: the fewest with a median that isn't one of the ends
  std::string shard, trials;  ///< "3/8" or "auto"; a file with keys of trials, "-" for standard input
  StudyOverrides overrides;
};

struct TrialsArguments {
  std::string study;
  StudyOverrides overrides;
};

struct EvaluateArguments {
  std::string study, problem, values, picture;  ///< `values`: a file of them, instead of the start's
  bool json = false;
  StudyOverrides overrides;
};

struct FitArguments {
  std::string study, problem, with, out, picture;
  bool validate = false;  ///< a validated stop, whatever the study says
  bool prune = false;
  double prune_loss = 0.01;  ///< how much larger the error may become by it, as a share
  StudyOverrides overrides;
};

struct ReportArguments {
  std::vector<std::string> directories;
  std::string out, latex;  ///< `latex`: a file for tables
};

struct MergeArguments {
  std::vector<std::string> directories;
  std::string out;
};

struct VerifyArguments {
  std::string directory;
  std::size_t trials = 10;
  std::uint64_t seed = 1;  ///< draws which
};

struct ExportArguments {
  std::vector<std::string> directories;
  std::string format, out;  ///< a name of exchange::formats()
};

struct ExplainArguments {
  std::string study;
  bool trials = false;
  StudyOverrides overrides;
};

struct InitArguments {
  std::string file, problem;            ///< without `file`: standard output
  std::vector<std::string> optimizers;  ///< as editing::TemplateRequest has them
};

struct SchemaArguments {};

struct ListArguments {
  std::string what;  ///< optimizers, problems, scenes, a list of a problem's, or all when empty
};

int compare_command(const CompareArguments& arguments, const Registry& registry);
int evaluate_command(const EvaluateArguments& arguments, const Registry& registry);
int fit_command(const FitArguments& arguments, const Registry& registry);
int report_command(const ReportArguments& arguments, const Registry& registry);
int merge_command(const MergeArguments& arguments, const Registry& registry);
int verify_command(const VerifyArguments& arguments, const Registry& registry);
int export_command(const ExportArguments& arguments, const Registry& registry);
int explain_command(const ExplainArguments& arguments, const Registry& registry);
int trials_command(const TrialsArguments& arguments, const Registry& registry);
int init_command(const InitArguments& arguments, const Registry& registry);
int schema_command(const SchemaArguments& arguments, const Registry& registry);
int list_command(const ListArguments& arguments, const Registry& registry);

inline constexpr int kExitTrialFailed = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitInterrupted = 130;
inline constexpr int kExitReaderGone = 141;  ///< whoever read standard output went before its end

}  // namespace nodal
