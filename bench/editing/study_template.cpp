// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_template.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/dense_matrix.h>
#include <nodal/shown.h>
#include <nodal/study.h>

namespace nodal::editing {

namespace {

constexpr std::string_view kBegin =
    R"(# A study: who races on what, for how long. Keys behind a '#' have the value that they have when left out.
#
#     nodal explain THIS_FILE    what it comes to, without running anything
#     nodal compare THIS_FILE    runs it and writes the report
#
# An editor that checks TOML by a JSON schema (taplo, Even Better TOML) completes and checks these keys:
# write one by `nodal schema > study.schema.json`, and make the first line  #:schema ./study.schema.json

)";

constexpr std::size_t kSuited = 2;  // methods that are taken unasked

std::string to_toml(const Value& value) {
  std::vector<std::string> parts;
  if (value.is_list()) {
    for (const Value& item : value.list()) parts.push_back(to_toml(item));
    return fmt::format("[{}]", fmt::join(parts, ", "));
  }
  if (!value.is_table()) return to_json(value);
  for (const auto& [key, entry] : value.table()) parts.push_back(fmt::format("{} = {}", key, to_toml(entry)));
  return parts.empty() ? "{}" : fmt::format("{{ {} }}", fmt::join(parts, ", "));
}

std::string meaning(const Option& option) {
  std::vector<std::string> parts;
  if (const std::string range = range_text(option); !range.empty()) parts.push_back(range);
  if (!option.unit.empty()) parts.push_back(fmt::format("[{}]", option.unit));
  if (!option.choices.empty()) parts.push_back(fmt::format("{}", fmt::join(option.choices, " | ")));
  std::string text = option.help;
  if (!parts.empty()) text += fmt::format("{}{}", text.empty() ? "" : "; ", fmt::join(parts, ", "));
  return text;
}

// A key with its default, so that taking the '#' away changes nothing; or what may stand there.
std::string key_line(const Option& option, const std::string& path) {
  const std::string name = path + option.name;
  const std::string begin =
      option.default_value
          ? fmt::format("# {} = {}", name, to_toml(*option.default_value))
          : fmt::format("# {}: {}{}{}", name, to_string(option.type), option.or_table ? " or table" : "",
                        option.default_text.empty() ? "" : fmt::format(" (default: {})", option.default_text));
  const std::string help = meaning(option);
  constexpr std::size_t kWidth = 44;
  const std::size_t gap = begin.size() < kWidth ? kWidth - begin.size() : 2;
  return help.empty() ? begin + "\n" : begin + std::string(gap, ' ') + "# " + help + "\n";
}

// What stands in a list's entries, or in a table in the place of a value: it can't be beside what is written there.
std::string field_lines(const OptionSchema& schema, const std::string& path) {
  std::string text;
  for (const Option& option : schema)
    text += fmt::format("#   {}{}: {}\n", path, option.name, meaning(option)) +
            field_lines(option.fields, path + option.name + ".");
  return text;
}

std::string key_lines(const OptionSchema& schema, const std::string& path = {}) {
  std::string text;
  for (const Option& option : schema) {
    const std::string inside = path + option.name + ".";
    if (option.fields.empty())
      text += key_line(option, path);
    else if (option.or_table || option.type == OptionType::table_list)
      text += key_line(option, path) + field_lines(option.fields, inside);
    else
      text += fmt::format("# {}{}: {}\n", path, option.name, option.help) + key_lines(option.fields, inside);
  }
  return text;
}

OptionSchema without(OptionSchema schema, std::initializer_list<std::string_view> names) {
  std::erase_if(schema, [&](const Option& option) { return std::ranges::find(names, option.name) != names.end(); });
  return schema;
}

const ProblemDescription& problem_of(const TemplateRequest& request, const Registry& registry) {
  std::vector<std::string> kinds;
  for (const ProblemDescription& problem : registry.problems()) kinds.push_back(problem.kind);
  if (kinds.empty()) throw InputError("this build has no problem");
  if (request.problem.empty())
    return *std::ranges::max_element(registry.problems(), {},
                                     [](const auto& problem) { return problem.options.size(); });
  const std::string& kind = request.problem;
  if (const ProblemDescription* found = registry.find_problem(kind)) return *found;
  throw InputError(Source{"--problem", 0}, fmt::format("unknown problem '{}'{}", shown(kind), name_hint(kind, kinds)));
}

const OptimizerDescription& method_of(const std::string& name, const Registry& registry) {
  if (const OptimizerDescription* found = registry.find_optimizer(name)) return *found;
  if (const AbsentDescription* absent = registry.find_absent(name))
    throw InputError(Source{"--optimizer", 0}, fmt::format("'{}' {}", shown(name), absent->reason));
  std::vector<std::string> names;
  for (const OptimizerDescription& method : registry.optimizers()) names.push_back(method.name);
  throw InputError(Source{"--optimizer", 0},
                   fmt::format("unknown optimizer '{}'{}", shown(name), name_hint(name, names)));
}

// Why a method can't run on a problem; empty where it can.
std::string unfit(const OptimizerDescription& method, const Problem& problem, const Registry& registry) {
  const std::vector<std::string> missing = problem.abilities().missing(method.needs);
  if (!missing.empty()) return fmt::format("needs {}, which the problem can't give", fmt::join(missing, " and "));
  return dense_matrix_refusal(method, problem, registry);
}

// Those of the highest ranks; where none calls itself suitable, the first that can run.
std::vector<const OptimizerDescription*> suited(const Problem& problem, const Registry& registry) {
  std::vector<std::pair<int, const OptimizerDescription*>> ranked;
  const OptimizerDescription* any = nullptr;
  for (const OptimizerDescription& method : registry.optimizers()) {
    if (!unfit(method, problem, registry).empty()) continue;
    if (!any) any = &method;
    if (!method.suits) continue;
    if (const std::optional<Suitability> suits = method.suits(problem)) ranked.emplace_back(suits->rank, &method);
  }
  std::ranges::stable_sort(ranked, std::greater{}, [](const auto& entry) { return entry.first; });
  if (ranked.size() > kSuited) ranked.resize(kSuited);
  std::vector<const OptimizerDescription*> methods;
  for (const auto& [rank, method] : ranked) methods.push_back(method);
  if (methods.empty() && any) methods.push_back(any);
  return methods;
}

std::vector<const OptimizerDescription*> methods_of(const TemplateRequest& request, const Problem& problem,
                                                    const Registry& registry) {
  std::vector<const OptimizerDescription*> methods;
  for (const std::string& name : request.optimizers) {
    methods.push_back(&method_of(name, registry));
    if (const std::string why = unfit(*methods.back(), problem, registry); !why.empty())
      throw InputError(Source{"--optimizer", 0}, fmt::format("'{}' {}", shown(name), why));
  }
  if (methods.empty()) methods = suited(problem, registry);
  if (methods.empty()) throw InputError("no optimizer of this build can run on the problem");
  return methods;
}

std::string optimizer_section(const OptimizerDescription& method, bool baseline) {
  OptionSchema own = without(optimizer_entry_schema(), {"use", "options"});
  std::string text = fmt::format("[[optimizer]]\nuse = {}    # {}\n", to_toml(method.name), method.summary);
  if (baseline) {
    text += "baseline = true\n";
    own = without(std::move(own), {"baseline"});
  }
  return text + key_lines(own) + key_lines(method.options, "options.") + "\n";
}

}  // namespace

std::string study_template(const TemplateRequest& request, const Registry& registry) {
  const ProblemDescription& kind = problem_of(request, registry);
  const std::string named = fmt::format("[problem]\nkind = {}    # {}\n", to_toml(kind.kind), kind.summary);
  const Study study = parse_study(named, "study", registry);
  std::string text(kBegin);
  text += "[study]\n" + key_lines(study_schema()) + "\n";
  text += "[budget]    # a trial ends at whichever comes first\nseconds = 1\nevaluations = 100000\n" +
          key_lines(without(budget_schema(), {"seconds", "evaluations"})) + "\n";
  text += named + key_lines(without(problem_entry_schema(), {"kind"})) + key_lines(kind.options) + "\n";
  bool baseline = true;
  for (const OptimizerDescription* method : methods_of(request, *study.problems[0].problem, registry)) {
    text += optimizer_section(*method, baseline);
    baseline = false;
  }
  text.pop_back();
  return text;
}

}  // namespace nodal::editing
