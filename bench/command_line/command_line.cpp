// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/command_line.h>

#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <new>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <nodal/error.h>
#include <nodal/provenance.h>

#include "commands.h"
#include "console.h"
#include "exchange/format.h"
#include "problem_command.h"
#include "usage_error.h"

namespace nodal {

namespace {

std::string version_text() {
  std::string text = fmt::format("nodal {} (revision {})\n", version(), revision());
  const Value here = provenance();
  text += fmt::format("compiler: {}, {}\n", here.at("compiler").text(), here.at("build_type").text());
  for (const auto& [name, number] : library_versions()) text += fmt::format("{}: {}\n", name, number);
  return text;
}

void describe(CLI::App& app) {
  app.description("Compares optimizers on fitting spring/mass systems to elastic bodies.");
  app.footer(
      "Start with: nodal compare bench/scenes/plate.toml\n"
      "Exit codes: 0 done, 1 a trial failed or a check differed, 2 bad input or usage, or output that can't be "
      "written,\n"
      "130 interrupted, 141 the reader of the output went away.");
  app.require_subcommand(1);
  app.set_help_all_flag("--help-all", "Help of all commands");
  app.add_flag_callback(
      "--version", [] { throw CLI::CallForVersion(version_text(), 0); }, "Revision and library versions");
}

// Adds a command; when it is chosen, its exit code lands in `exit`.
template <class Arguments>
CLI::App& add_command(CLI::App& app, const char* name, const char* help, int (*run)(const Arguments&, const Registry&),
                      const Registry& registry, int& exit, const std::shared_ptr<Arguments>& arguments) {
  CLI::App* command = app.add_subcommand(name, help);
  command->callback([=, &registry, &exit] { exit = run(*arguments, registry); });
  return *command;
}

void add_study(CLI::App& command, std::string& path, StudyOverrides& overrides) {
  command.add_option("study", path, "The study, a TOML file")->required()->type_name("STUDY");
  command
      .add_option("--set", overrides.set,
                  "Any key of the study, as problem.material.poisson=0.2; problem[LABEL].… means one entry of several")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_problem_label(CLI::App& command, std::string& label) {
  command.add_option("--problem", label, "Which problem, where a study has several")->type_name("LABEL");
}

void add_picture(CLI::App& command, std::string& path) {
  command.add_option("--picture", path, "Draw the system, where its problem has a picture")->type_name("FILE.svg");
}

void add_repeats(CLI::App& command, StudyOverrides& overrides) {
  command.add_option("--repeats", overrides.repeats, "Repeats, instead of the study's")->check(above_zero());
}

// Checked here, so that a message names the option.
void add_budget(CLI::App& command, StudyOverrides& overrides) {
  command.add_option("--seconds", overrides.seconds, "Wall time per trial [s], instead of the study's")
      ->check(above_zero());
  command.add_option("--evaluations", overrides.evaluations, "Evaluations per trial, instead of the study's")
      ->check(whole_number_from(1));
  command.add_option("--seed", overrides.seed, "Seed, instead of the study's")->check(whole_number_from(0));
}

void add_rerun(CLI::App& command, CompareArguments& to) {
  CLI::Option* rerun =
      command
          .add_option(
              "--rerun", to.rerun,
              "Run stored trials again: of these optimizers (as for --only), those that 'failed', or those that are "
              "'contaminated'; the results before stay in their files")
          ->type_name("LABEL,…")
          ->allow_extra_args(false);
  command.add_flag("--fresh", to.fresh, "Run every trial of the study again")->excludes(rerun);
}

void add_only(CLI::App& command, StudyOverrides& overrides) {
  command
      .add_option(
          "--only", overrides.only,
          "Only the optimizers with these labels, or with a 'use' that one entry has, separated by commas; may be "
          "repeated")
      ->type_name("LABEL,…")
      ->allow_extra_args(false);
  command.add_option("--problem", overrides.only_problems, "Only the problem with this label; may be repeated")
      ->type_name("LABEL")
      ->allow_extra_args(false);
}

void add_share(CLI::App& command, CompareArguments& to) {
  CLI::Option* shard = command
                           .add_option("--shard", to.shard,
                                       "Run the K-th of N shares of the trials, or what a scheduler says (auto: Slurm, "
                                       "Open MPI, PMI), into a store that others write to; no report")
                           ->type_name("K/N");
  command.add_option("--trials", to.trials, "Run the trials with the keys in this file, one a line (- is stdin)")
      ->type_name("FILE")
      ->excludes(shard);
}

void add_jobs(CLI::App& command, CompareArguments& to) {
  command.add_option("--jobs", to.jobs, "Trials at once; times stay clean with 1 (default)")->check(above_zero());
  command
      .add_option("--time-lane", to.time_lane,
                  "Of trials that ran beside others, how many of each optimizer on each problem run once more alone, "
                  "for their times (default: 3; 0: none)")
      ->check(not_below_zero())
      ->excludes(command.get_option("--shard"))
      ->excludes(command.get_option("--trials"));
}

void add_trials(CLI::App& app, const Registry& registry, int& exit) {
  const auto to = std::make_shared<TrialsArguments>();
  CLI::App& command =
      add_command(app, "trials", "Keys of a study's trials, for compare --trials", trials_command, registry, exit, to);
  add_study(command, to->study, to->overrides);
  add_only(command, to->overrides);
  add_repeats(command, to->overrides);
  add_budget(command, to->overrides);
}

void add_compare(CLI::App& app, const Registry& registry, int& exit) {
  const auto to = std::make_shared<CompareArguments>();
  CLI::App& command =
      add_command(app, "compare", "Run what the store lacks of a study, print the table, write the report",
                  compare_command, registry, exit, to);
  add_study(command, to->study, to->overrides);
  command.add_option("--out", to->out, "Where results are stored (default: results/<name of the study>)")
      ->type_name("DIR");
  add_only(command, to->overrides);
  add_rerun(command, *to);
  add_share(command, *to);
  add_repeats(command, to->overrides);
  add_budget(command, to->overrides);
  add_jobs(command, *to);
}

void add_evaluate(CLI::App& app, const Registry& registry, int& exit) {
  const auto to = std::make_shared<EvaluateArguments>();
  CLI::App& command =
      add_command(app, "evaluate", "Error, error per load, bearing forces at the start or at given stiffnesses",
                  evaluate_command, registry, exit, to);
  add_study(command, to->study, to->overrides);
  add_problem_label(command, to->problem);
  command
      .add_option("--stiffness,--values", to->values, "A stiffness file instead of the start; bounds don't apply to it")
      ->type_name("FILE");
  add_picture(command, to->picture);
  command.add_flag("--json", to->json, "Everything, displacements too, as JSON");
}

void add_fit(CLI::App& app, const Registry& registry, int& exit) {
  const auto to = std::make_shared<FitArguments>();
  CLI::App& command =
      add_command(app, "fit", "One run, by default with the method that suits the problem; writes the fitted system",
                  fit_command, registry, exit, to);
  add_study(command, to->study, to->overrides);
  add_problem_label(command, to->problem);
  command
      .add_option(
          "--with", to->with,
          "A label of the study, or any optimizer, with the options of the study's entry that uses it if there is one")
      ->type_name("NAME");
  command.add_flag("--validate", to->validate,
                   "Of the points on the way take the one that does best on every second thing that is held out; "
                   "the others say how good it is");
  const auto prune = command.add_flag("--prune", to->prune,
                                      "Leave out what the system can do without (springs at the lower bound), fit "
                                      "the rest again, and say what that costs");
  command
      .add_option("--prune-loss", to->prune_loss,
                  "How much larger --prune may make the error before the second fit, as a share of it (default: 0.01)")
      ->type_name("SHARE")
      ->check(not_below_zero())
      ->needs(prune);
  command
      .add_option("--export", to->out,
                  "Where the fitted system goes, in the format that the name ends in (default: stdout)")
      ->type_name("FILE");
  add_picture(command, to->picture);
  add_budget(command, to->overrides);
}

void add_report(CLI::App& app, const Registry& registry, int& exit) {
  const auto to = std::make_shared<ReportArguments>();
  CLI::App& command = add_command(app, "report", "Make table, CSV files and report.html again from stored trials",
                                  report_command, registry, exit, to);
  command.add_option("stores", to->directories, "Directories that nodal compare wrote")->required()->type_name("DIR…");
  command.add_option("--out", to->out, "Where the files go (default: into the one store)")->type_name("DIR");
  command.add_option("--latex", to->latex, "Write the answer and each problem's results as LaTeX tables, too")
      ->type_name("FILE");
}

void add_merge(CLI::App& app, const Registry& registry, int& exit) {
  const auto to = std::make_shared<MergeArguments>();
  CLI::App& command = add_command(app, "merge", "Put several stores into a new one, which goes on like any other",
                                  merge_command, registry, exit, to);
  command.add_option("stores", to->directories, "Directories that nodal compare wrote")->required()->type_name("DIR…");
  command.add_option("--out", to->out, "The new store's directory")->required()->type_name("DIR");
}

void add_verify(CLI::App& app, const Registry& registry, int& exit) {
  const auto to = std::make_shared<VerifyArguments>();
  CLI::App& command = add_command(app, "verify", "Run some of a store's trials again and say whether they do the same",
                                  verify_command, registry, exit, to);
  command.add_option("store", to->directory, "A directory that nodal compare wrote")->required()->type_name("DIR");
  command.add_option("--trials", to->trials, "How many (default: 10)")->check(whole_number_from(1));
  command.add_option("--seed", to->seed, "Which (default: 1)")->check(whole_number_from(0));
}

void add_export(CLI::App& app, const Registry& registry, int& exit) {
  const auto to = std::make_shared<ExportArguments>();
  CLI::App& command = add_command(app, "export", "Write stored trials for the tools of other benchmarks",
                                  export_command, registry, exit, to);
  command.add_option("stores", to->directories, "Directories that nodal compare wrote")->required()->type_name("DIR…");
  std::vector<std::string> names;
  std::string help = "In which format:";
  for (const exchange::Format& format : exchange::formats()) {
    names.emplace_back(format.name);
    help += fmt::format("{} {} ({})", names.size() == 1 ? "" : ",", format.name, format.summary);
  }
  command.add_option("--format", to->format, help)->required()->check(CLI::IsMember(names));
  command.add_option("--out", to->out, "Where they go, a folder for each optimizer: a new folder")
      ->required()
      ->type_name("DIR");
}

void add_explain(CLI::App& app, const Registry& registry, int& exit) {
  const auto to = std::make_shared<ExplainArguments>();
  CLI::App& command =
      add_command(app, "explain", "What a study uses and leaves out, sizes, start, limits, its trials; runs nothing",
                  explain_command, registry, exit, to);
  add_study(command, to->study, to->overrides);
  command.add_flag("--trials", to->trials, "Every trial with its key");
  add_repeats(command, to->overrides);
  add_budget(command, to->overrides);
}

void add_init(CLI::App& app, const Registry& registry, int& exit) {
  const auto to = std::make_shared<InitArguments>();
  CLI::App& command =
      add_command(app, "init", "Write a study to begin with, every key explained", init_command, registry, exit, to);
  command.add_option("file", to->file, "A new file (default: stdout)")->type_name("FILE");
  std::vector<std::string> kinds;
  for (const ProblemDescription& problem : registry.problems()) kinds.push_back(problem.kind);
  command
      .add_option("--problem", to->problem,
                  fmt::format("Which problem: {} (default: the one with the most keys)", fmt::join(kinds, ", ")))
      ->type_name("KIND");
  command
      .add_option("--optimizer", to->optimizers,
                  "A method that races, as nodal list optimizers names it; may be repeated (default: what suits)")
      ->type_name("USE")
      ->allow_extra_args(false);
}

void add_schema(CLI::App& app, const Registry& registry, int& exit) {
  add_command(app, "schema", "Print the JSON schema of studies, for editors", schema_command, registry, exit,
              std::make_shared<SchemaArguments>());
}

void add_list(CLI::App& app, const Registry& registry, int& exit) {
  const auto to = std::make_shared<ListArguments>();
  CLI::App& command = add_command(app, "list", "What this build has, with needs and options, and what it lacks",
                                  list_command, registry, exit, to);
  std::vector<std::string> lists = {"optimizers", "problems"};
  for (const ProblemDescription& problem : registry.problems())
    for (const Listing& listing : problem.listings) lists.push_back(listing.name);
  lists.emplace_back("scenes");
  const std::string all_but_last = fmt::format("{}", fmt::join(lists.begin(), lists.end() - 1, ", "));
  command.add_option("what", to->what, fmt::format("{} or {}; all when left out", all_but_last, lists.back()))
      ->check(CLI::IsMember(lists));
}

int run_command(const Registry& registry, int argc, const char* const* argv) {
  CLI::App app("", "nodal");
  int exit = 0;
  describe(app);
  add_compare(app, registry, exit);
  add_evaluate(app, registry, exit);
  add_fit(app, registry, exit);
  add_report(app, registry, exit);
  add_merge(app, registry, exit);
  add_verify(app, registry, exit);
  add_export(app, registry, exit);
  add_explain(app, registry, exit);
  add_trials(app, registry, exit);
  for (const ProblemDescription& problem : registry.problems())
    for (const Command& command : problem.commands) add_problem_command(app, command, registry, exit);
  add_list(app, registry, exit);
  add_init(app, registry, exit);
  add_schema(app, registry, exit);
  refuse_empty_texts(app);
  try {
    app.parse(argc, argv);
    return exit;
  } catch (const CLI::Success& done) {  // --help, --version
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    say("nodal", describe_usage_error(app, error, argc, argv));
  } catch (const std::bad_alloc&) {
    say("nodal", "there is not enough memory for this");
  } catch (const std::exception& error) {  // InputError, StoreError, and what else a library may throw
    say("nodal", error.what());
  } catch (...) {  // of a problem or an optimizer that isn't ours
    say("nodal", "something was thrown that is no std::exception");
  }
  return kExitBadInput;
}

}  // namespace

int command_line(const Registry& registry, int argc, const char* const* argv) {
  Console console;
  return console.finish(run_command(registry, argc, argv));
}

}  // namespace nodal
