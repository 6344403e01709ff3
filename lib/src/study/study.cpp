// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/study.h>

#include <algorithm>
#include <cmath>
#include <new>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/file.h>
#include <nodal/shown.h>
#include <nodal/toml.h>
#include <nodal/unseen.h>

#include "rerun.h"
#include "study/best_known.h"
#include "study/includes.h"
#include "study/instances.h"
#include "study/optimizer_choice.h"
#include "study/patterns.h"
#include "study/settings.h"

namespace nodal {

namespace {

template <class Items>
std::vector<std::string> names_of(const Items& items, std::string Items::value_type::*member) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.*member);
  return names;
}

constexpr std::size_t kMostOfALabel = 100, kMostOfAnOrigin = 1000;  // [characters]

// All that a command line changes of what is run, as settings: whoever applies them to the text has the same trials.
std::vector<std::string> settings_of(const StudyOverrides& overrides) {
  std::vector<std::string> settings = overrides.set;
  const auto add = [&settings](const char* key, const Value& value) {
    settings.push_back(fmt::format("{}={}", key, to_json(value)));
  };
  if (overrides.seconds) add("budget.seconds", Value(*overrides.seconds));
  if (overrides.evaluations) add("budget.evaluations", Value(*overrides.evaluations));
  if (overrides.seed) add("study.seed", Value(*overrides.seed));
  if (overrides.repeats) add("study.repeats", Value(*overrides.repeats));
  return settings;
}

// A problem with ranges becomes several.
void spread_problems(Value& root) {
  const auto found = std::ranges::find(root.table(), "problem", &Value::Table::value_type::first);
  if (found == root.table().end()) return;
  Value& problems = found->second;
  Value::List given = problems.is_list() ? problems.list() : Value::List{problems}, spread;
  for (const Value& entry : given)
    if (entry.is_table())
      for (Value& one : instances(entry, entry.text_or("kind", "problem"))) spread.push_back(std::move(one));
    else
      spread.push_back(entry);
  const Source source = problems.source;
  problems = !problems.is_list() && spread.size() == 1 ? std::move(spread.front()) : Value(std::move(spread));
  problems.source = source;
}

Value tables_of(std::string_view text, const std::filesystem::path& path, const StudyOverrides& overrides,
                std::vector<IncludedFile>& included) {
  Value root = with_includes(parse_toml(text, path.string()), path, overrides.included, included);
  apply_settings(root, overrides.set);
  spread_problems(root);
  return root;
}

// Reads one study; members are filled in the order of `read`.
class StudyReader {
 public:
  StudyReader(std::string_view text, const std::filesystem::path& path, const Registry& registry,
              const StudyOverrides& overrides)
      : file_(path.string()), registry_(registry), overrides_(overrides) {
    study_.text = std::string(text);
    study_.path = path;
    root_ = tables_of(text, path, overrides, study_.included);
  }

  Study read() {
    refuse_unknown_tables();
    read_study_table();
    read_budget();
    for (const Value* entry : entries("problem", true)) read_problem(*entry);
    keep_only_problems();
    read_optimizers();
    keep_only();
    check_needs();
    check_target();
    check_stop();
    study_.settings = settings_of(overrides_);
    return std::move(study_);
  }

 private:
  void refuse_unknown_tables() const {
    const std::vector<std::string> known = {"study", "budget", "problem", "optimizer"};
    for (const auto& [key, value] : root_.table())
      if (std::ranges::find(known, key) == known.end())
        throw InputError(value.source,
                         fmt::format("unknown table or key '{}' in the study{}", shown(key), name_hint(key, known)));
  }

  Options section(const char* name, const OptionSchema& schema) const {
    const Value* given = root_.find(name);
    Value empty;
    empty.source = {file_, 0};
    return resolve_options(schema, given ? *given : empty, fmt::format("[{}]", name));
  }

  // [name] or [[name]].
  std::vector<const Value*> entries(const char* name, bool required) const {
    const Value* found = root_.find(name);
    const bool nothing = !found || (found->is_list() && found->list().empty());
    if (nothing && required) throw InputError({file_, 0}, fmt::format("missing table [{}]; a study needs one", name));
    std::vector<const Value*> list;
    if (!found) return list;
    if (found->is_table()) return {found};
    if (!found->is_list())
      throw InputError(found->source, fmt::format("'{}' must be a table, not {}", name, found->type_name()));
    for (const Value& item : found->list()) {
      if (!item.is_table())
        throw InputError(item.source, fmt::format("'{}' must be a table, not {}", name, item.type_name()));
      list.push_back(&item);
    }
    return list;
  }

  void read_study_table() {
    const Options options = section("study", study_schema());
    require_short(options.has("name") ? &options.at("name") : nullptr, "name", "[study]", kMostOfALabel);
    study_.name = options.has("name") ? options.text("name") : study_.path.stem().string();
    const auto awkward = [](char c) { return c == '/' || c == '\\' || (c >= 0 && c < 0x20); };
    const bool plain = !study_.name.empty() && study_.name[0] != '.' && std::ranges::none_of(study_.name, awkward);
    if (!plain)
      throw InputError(options.has("name") ? options.at("name").source : Source{file_, 0},
                       fmt::format("'{}' can't be the name of a study: it names a folder", shown(study_.name)));
    study_.seed = overrides_.seed.value_or(static_cast<std::uint64_t>(options.integer("seed")));
    study_.repeats = overrides_.repeats.value_or(static_cast<int>(options.integer("repeats")));
    study_.starts = options.text("starts") == "initial" ? Starts::initial : Starts::sampled;
    check_repeats();
  }

  // Those of the command line keep to the schema, too.
  void check_repeats() const {
    const OptionSchema schema = study_schema();
    const Option& repeats = *std::ranges::find(schema, "repeats", &Option::name);
    if (study_.repeats < repeats.minimum || study_.repeats > repeats.maximum)
      throw InputError(Source{"--repeats", 0}, fmt::format("is {}; allowed: {}", study_.repeats, range_text(repeats)));
  }

  void read_budget() {
    const Options options = section("budget", budget_schema());
    if (options.has("seconds")) study_.budget.seconds = options.number("seconds");
    if (options.has("evaluations")) study_.budget.evaluations = options.integer("evaluations");
    if (options.has("target_gap")) {
      study_.budget.target_gap = options.number("target_gap");
      target_source_ = options.at("target_gap").source;
    }
    if (options.has("stop")) {
      study_.budget.validated = true;
      stop_source_ = options.at("stop").source;
    }
    if (overrides_.seconds) study_.budget.seconds = overrides_.seconds;
    if (overrides_.evaluations) study_.budget.evaluations = overrides_.evaluations;
    if (overrides_.seconds && !(*overrides_.seconds > 0.0))
      throw InputError(Source{"--seconds", 0}, fmt::format("is {}; it must be > 0", *overrides_.seconds));
    if (overrides_.seconds && !std::isfinite(*overrides_.seconds))
      throw InputError(Source{"--seconds", 0}, fmt::format("is {}; it must be finite", *overrides_.seconds));
    if (overrides_.evaluations && *overrides_.evaluations < 1)
      throw InputError(Source{"--evaluations", 0},
                       fmt::format("is {}; it must be at least 1", *overrides_.evaluations));
  }

  // The entry without the keys that belong to somebody else.
  static Value only_keys(const Value& entry, const OptionSchema& schema, bool inside) {
    Value part;
    part.source = entry.source;
    for (const auto& [key, value] : entry.table()) {
      const bool known = std::ranges::find(schema, key, &Option::name) != schema.end();
      if (known == inside) part.table().emplace_back(key, value);
    }
    return part;
  }

  void read_problem(const Value& entry) {
    const OptionSchema own = problem_entry_schema();
    const Options options = resolve_options(own, only_keys(entry, own, true), "[problem]");
    StudyProblem problem;
    problem.kind = options.text("kind");
    problem.label = options.has("label") ? options.text("label") : problem.kind;
    const ProblemDescription* description = registry_.find_problem(problem.kind);
    if (!description)
      throw InputError(options.at("kind").source,
                       fmt::format("unknown problem '{}'{}", shown(problem.kind),
                                   name_hint(problem.kind, names_of(registry_.problems(), &ProblemDescription::kind))));
    claim_label(problem.label, entry, problem_labels_, "problems", "[problem]");
    problem.options = resolve_options(description->options, only_keys(entry, own, false),
                                      fmt::format("problem '{}'", shown(problem.label)));
    make(*description, entry, problem);
    if (!options.has("best_known"))
      problem.best_known = problem.problem->known_optimum();
    else
      give_best_known(options.table("best_known"), entry, problem);
    study_.problems.push_back(std::move(problem));
  }

  void make(const ProblemDescription& description, const Value& entry, StudyProblem& problem) const {
    guarded(entry, problem, [&] {
      InputFiles files(study_.path.parent_path());
      const ResultCache cache = overrides_.cache ? ResultCache(overrides_.cache(study_.name)) : ResultCache();
      problem.problem = description.make(problem.options, {files, entry.source, cache});
      problem.fingerprint = files.fingerprint();
    });
  }

  void give_best_known(const Options& known, const Value& entry, StudyProblem& problem) const {
    require_short(&known.at("origin"), "origin", "best_known", kMostOfAnOrigin);
    // A file may be what the study is read for: a fit writes it.
    if (overrides_.without_best_known_files && known.has("file") && !study_.budget.target_gap) return;
    guarded(entry, problem,
            [&] { problem.best_known = read_best_known(known, *problem.problem, study_.path.parent_path()); });
  }

  // Whatever a problem throws is told with its place and name.
  template <class Make>
  static void guarded(const Value& entry, const StudyProblem& problem, Make make) {
    try {
      make();
    } catch (const InputError&) {  // says where and what
      throw;
    } catch (const std::bad_alloc&) {
      throw InputError(entry.source, fmt::format("problem '{}' takes more memory than there is; make it smaller",
                                                 shown(problem.label)));
    } catch (const std::exception& error) {
      throw InputError(entry.source, fmt::format("problem '{}' can't be made: {}", shown(problem.label), error.what()));
    } catch (...) {
      throw InputError(entry.source, fmt::format("problem '{}' can't be made: an exception that is no std::exception",
                                                 shown(problem.label)));
    }
  }

  void read_optimizers() {
    const std::vector<const Value*> all = entries("optimizer", false);
    for (const Value* entry : all) {
      const bool pattern = is_pattern(entry->text_or("use", ""));
      const std::vector<Value> meant = pattern ? methods_meant(*entry, all, registry_) : std::vector{*entry};
      for (const Value& one : meant)
        for (const Value& instance : instances(one, one.text_or("use", "optimizer"))) read_optimizer(instance, pattern);
    }
  }

  // What a pattern means and some problem can't serve is left out; what was asked for by name is refused, by
  // check_needs.
  void read_optimizer(const Value& entry, bool by_pattern) {
    const Options options = resolve_options(optimizer_entry_schema(), without_options(entry), "[[optimizer]]");
    StudyOptimizer optimizer;
    optimizer.use = options.text("use");
    optimizer.label = options.has("label") ? options.text("label") : optimizer.use;
    claim_label(optimizer.label, entry, optimizer_labels_, "optimizers", "[[optimizer]]");
    if (const std::string meaning = meaning_for_rerun(optimizer.label); !meaning.empty())
      throw InputError(options.has("label") ? options.at("label").source : entry.source,
                       fmt::format("an optimizer can't be labelled '{}': --rerun {} means {}", optimizer.label,
                                   optimizer.label, meaning));
    const OptimizerDescription* description = registry_.find_optimizer(optimizer.use);
    if (!description) {
      leave_out(optimizer, options.at("use").source);
      return;
    }
    optimizer.multi_start = options.boolean("multi_start");
    if (const std::string refusal = by_pattern ? unfit(optimizer) : ""; !refusal.empty()) {
      study_.left_out.push_back({optimizer.label, optimizer.use, refusal});
      return;
    }
    Value own;
    own.source = entry.source;
    if (const Value* given = entry.find("options")) own = *given;
    optimizer.options =
        resolve_options(description->options, own, fmt::format("optimizer '{}'", shown(optimizer.label)));
    optimizer.baseline = options.boolean("baseline");
    optimizer.deterministic = description->deterministic && !optimizer.multi_start;
    if (optimizer.multi_start && !description->uses_start)
      throw InputError(options.at("multi_start").source,
                       fmt::format("'multi_start' of optimizer '{}' gives a method many starts; '{}' looks at none",
                                   shown(optimizer.label), optimizer.use));
    if (optimizer.baseline && std::ranges::any_of(study_.optimizers, &StudyOptimizer::baseline))
      throw InputError(options.at("baseline").source,
                       fmt::format("optimizer '{}' is a second baseline; only one can be", shown(optimizer.label)));
    study_.optimizers.push_back(std::move(optimizer));
  }

  // `options` belongs to the method, whose schema is not known yet.
  static Value without_options(const Value& entry) {
    Value part;
    part.source = entry.source;
    for (const auto& [key, value] : entry.table())
      if (key != "options") part.table().emplace_back(key, value);
    return part;
  }

  void leave_out(const StudyOptimizer& optimizer, const Source& source) {
    if (const AbsentDescription* absent = registry_.find_absent(optimizer.use)) {
      study_.left_out.push_back({optimizer.label, optimizer.use, absent->reason});
      return;
    }
    throw InputError(
        source, fmt::format("unknown optimizer '{}'{}", shown(optimizer.use),
                            name_hint(optimizer.use, names_of(registry_.optimizers(), &OptimizerDescription::name))));
  }

  // These texts stand in every row, message and picture that speaks of what they name.
  static void require_short(const Value* text, const char* key, const char* table, std::size_t most) {
    if (!text) return;
    std::size_t characters = 0;
    for (std::string_view rest = text->text(); !rest.empty(); ++characters)
      rest.remove_prefix(std::max<std::size_t>(1, utf8_character_size(rest)));
    if (characters > most)
      throw InputError(text->source, fmt::format("'{}' of {} has {} characters; at most {} are allowed", key, table,
                                                 characters, most));
  }

  using Labels = std::vector<std::pair<std::string, Source>>;
  static void claim_label(const std::string& label, const Value& entry, Labels& taken, const char* what,
                          const char* table) {
    if (const Value* given = entry.find("label"); given && label.empty())
      throw InputError(given->source, fmt::format("'label' of {} is empty; it names rows and results", table));
    require_short(entry.find("label"), "label", table, kMostOfALabel);
    if (const Value* given = entry.find("label"); given && shown(label, label.size()) != label)
      throw InputError(given->source, fmt::format("'label' of {} has a character that is no part of a line: '{}'",
                                                  table, shown(label)));
    const auto found = std::ranges::find(taken, label, &Labels::value_type::first);
    if (found != taken.end())
      throw InputError(entry.source, fmt::format("two {} have the label '{}' ({}); give one a 'label' of its own", what,
                                                 shown(label), where(found->second, entry.source)));
    taken.emplace_back(label, entry.source);
  }

  // Of two with one label the other.
  static std::string where(const Source& other, const Source& here) {
    if (other.file != here.file) return "the other: " + other.text();
    if (other.line != here.line) return fmt::format("the other is on line {}", other.line);
    return "both of one entry: values of a range that are the same, or patterns that overlap";
  }

  void keep_only() {
    std::vector<bool> wanted(study_.optimizers.size(), false);
    const std::vector<std::string> words = split_choice(study_, overrides_.only);
    for (const std::string& word : words) wanted[chosen_optimizer(study_, word, "--only")] = true;
    if (!words.empty()) {
      for (std::size_t i = 0; i < wanted.size(); ++i) study_.optimizers[i].skipped = !wanted[i];
      study_.left_out.clear();
    }
    if (study_.optimizers.empty() && !study_.left_out.empty())
      throw InputError({file_, 0}, fmt::format("none of the study's optimizers can run: '{}' {}",
                                               shown(study_.left_out[0].label), study_.left_out[0].reason));
  }

  void keep_only_problems() {
    const std::vector<std::string> labels = names_of(study_.problems, &StudyProblem::label);
    for (const std::string& label : overrides_.only_problems)
      if (std::ranges::find(labels, label) == labels.end())
        throw InputError(Source{"--problem", 0}, fmt::format("no problem of the study is labelled '{}'{}", shown(label),
                                                             name_hint(label, labels)));
    if (overrides_.only_problems.empty()) return;
    for (StudyProblem& problem : study_.problems)
      problem.skipped = std::ranges::find(overrides_.only_problems, problem.label) == overrides_.only_problems.end();
  }

  // Why a method can't run, by itself or on some problem of the study; empty where it can on all.
  std::string unfit(const StudyOptimizer& optimizer) const {
    const OptimizerDescription& description = *registry_.find_optimizer(optimizer.use);
    if (optimizer.multi_start && !description.uses_start) return "looks at no start, and 'multi_start' gives it many";
    for (const StudyProblem& problem : study_.problems) {
      if (problem.skipped) continue;
      const std::vector<std::string> missing = problem.problem->abilities().missing(description.needs);
      if (!missing.empty())
        return fmt::format("needs {}, which problem '{}' can't give", fmt::join(missing, " and "),
                           shown(problem.label));
      const std::string refusal = dense_matrix_refusal(description, *problem.problem, registry_);
      if (!refusal.empty()) return fmt::format("on problem '{}' {}", shown(problem.label), refusal);
    }
    return {};
  }

  void check_needs() const {
    for (const StudyOptimizer& optimizer : study_.optimizers) {
      if (optimizer.skipped) continue;
      const auto labelled = std::ranges::find(optimizer_labels_, optimizer.label, &Labels::value_type::first);
      if (const std::string refusal = unfit(optimizer); !refusal.empty())
        throw InputError(labelled->second, fmt::format("optimizer '{}' {}", shown(optimizer.label), refusal));
    }
  }

  void check_target() const {
    if (!study_.budget.target_gap) return;
    for (const StudyProblem& problem : study_.problems)
      if (!problem.best_known)
        throw InputError(target_source_,
                         fmt::format("'target_gap' needs to know the best quality of problem '{}'; give it "
                                     "best_known = {{ quality = …, origin = \"…\" }}",
                                     shown(problem.label)));
  }

  void check_stop() const {
    if (!study_.budget.validated) return;
    for (const StudyProblem& problem : study_.problems)
      if (const std::string refusal = validated_stop_refusal(*problem.problem); !refusal.empty())
        throw InputError(stop_source_,
                         fmt::format("stop = \"unseen\": of problem '{}' {}", shown(problem.label), refusal));
  }

  std::string file_;
  const Registry& registry_;
  const StudyOverrides& overrides_;
  Value root_;
  Study study_;
  Source target_source_, stop_source_;
  Labels problem_labels_, optimizer_labels_;
};

}  // namespace

Value study_tables(std::string_view text, const std::filesystem::path& path, const StudyOverrides& overrides) {
  std::vector<IncludedFile> included;
  return tables_of(text, path, overrides, included);
}

Study parse_study(std::string_view text, const std::filesystem::path& path, const Registry& registry,
                  const StudyOverrides& overrides) {
  return StudyReader(text, path, registry, overrides).read();
}

Study read_study(const std::filesystem::path& path, const Registry& registry, const StudyOverrides& overrides) {
  return parse_study(read_file(path, "study"), path, registry, overrides);
}

}  // namespace nodal
