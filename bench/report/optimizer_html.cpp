// SPDX-License-Identifier: GPL-3.0-or-later
// A section per optimizer: how it was set and, problem by problem, every trial.
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/show/html.h>
#include <nodal/show/number_text.h>

#include "chart/svg_chart.h"
#include "page_parts.h"
#include "race_chart.h"

namespace nodal::report {

namespace {

std::string option_text(const Value& value) { return value.is_text() ? value.text() : to_json(value); }

std::string optional_text(const std::optional<Value>& value) { return value ? escape_html(option_text(*value)) : "–"; }

std::string scroll(const std::string& label, const std::string& table) {
  return fmt::format("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">{}</div>\n",
                     escape_html(label), table);
}

// How an option was set on some of the problems.
struct OptionOn {
  const OptionDetail* option;
  std::vector<std::string> problems;
};

struct DetailOn {
  const OptimizerDetail* detail;
  std::string problem;
};

bool set_alike(const OptionDetail& a, const OptionDetail& b) {
  return a.requested == b.requested && a.effective == b.effective && a.varies == b.varies;
}

// Every option, the first problem's first; of each the ways in which it was set.
std::vector<std::vector<OptionOn>> option_ways(const std::vector<DetailOn>& details) {
  std::vector<std::vector<OptionOn>> options;
  for (const auto& [detail, problem] : details)
    for (const OptionDetail& option : detail->options) {
      auto ways = std::ranges::find(options, option.name, [](const auto& w) { return w.front().option->name; });
      if (ways == options.end()) ways = options.insert(ways, std::vector<OptionOn>());
      auto way = std::ranges::find_if(*ways, [&](const OptionOn& w) { return set_alike(*w.option, option); });
      if (way == ways->end()) way = ways->insert(way, OptionOn{&option, {}});
      way->problems.push_back(problem);
    }
  return options;
}

std::string option_row(const OptionOn& way, bool everywhere, bool knows_request) {
  const OptionDetail& option = *way.option;
  const bool differs = option.differs();
  const std::string where = everywhere ? "" : fmt::format(" on {}", fmt::join(way.problems, ", "));
  return fmt::format("<tr{}><th scope=\"row\"><code>{}</code>{}</th>{}<td>{}{}{}</td><td>{}</td></tr>\n",
                     differs ? " class=\"differs\"" : "", escape_html(option.name), escape_html(where),
                     knows_request ? "<td>" + optional_text(option.requested) + "</td>" : "",
                     optional_text(option.effective), differs ? " <strong>(not as asked for)</strong>" : "",
                     option.varies ? " (in the first trial; others differ)" : "", escape_html(option.help));
}

std::string options_html(const std::vector<DetailOn>& details) {
  const OptimizerDetail& detail = *details.front().detail;
  const std::vector<std::vector<OptionOn>> options = option_ways(details);
  if (options.empty()) return "<p>It has no options.</p>\n";
  std::string rows;
  for (const std::vector<OptionOn>& ways : options)
    for (const OptionOn& way : ways)
      rows += option_row(way, way.problems.size() == details.size(), detail.knows_request);
  return scroll("Options of " + detail.label,
                fmt::format("<table class=\"plain options\"><caption>Options</caption><thead><tr><th "
                            "scope=\"col\">option</th>{}<th scope=\"col\">ran with</th><th scope=\"col\">meaning</th>"
                            "</tr></thead><tbody>\n{}</tbody></table>",
                            detail.knows_request ? "<th scope=\"col\">asked for</th>" : "", rows));
}

// Every repeat's curve, thin, in the colour that the optimizer has in the race.
LineChart repeats_chart(const ProblemReport& problem, const OptimizerDetail& detail) {
  const double factor = problem.error_per_quality.value_or(1.0);
  LineChart chart;
  chart.title = fmt::format("{} on {}: {} of every repeat against time", detail.label, problem.table.reference.label,
                            height_title(problem, Raced::quality));
  chart.description = "Best so far of each trial; the table below has where they ended.";
  chart.size = {560.0, 240.0};
  chart.named = false;
  chart.x = {"time", Scale::logarithmic, true};
  chart.y = {height_title(problem, Raced::quality), Scale::logarithmic};
  for (const RepeatDetail& repeat : detail.repeats) {
    ChartLine line = line_named(problem, detail.label);
    line.label = fmt::format("repeat {}", repeat.repeat);
    line.thin = true;
    for (const CurvePoint& p : repeat.curve) {
      const double y = p.quality.median * factor;
      line.points.push_back({p.position, y, y, y});
    }
    chart.lines.push_back(std::move(line));
  }
  return chart;
}

std::string repeat_row(const RepeatDetail& repeat, bool has_error) {
  const std::optional<double> figure = has_error ? repeat.relative_error : repeat.quality;
  std::string how = std::string(to_string(repeat.end)) + (repeat.reason.empty() ? "" : ": " + repeat.reason);
  if (!repeat.contamination.empty()) how += "; times not to be trusted: " + repeat.contamination;
  const auto seconds = [](const std::optional<double>& s) { return s ? seconds_text(*s) : "–"; };
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"words\">{}"
      "</td></tr>\n",
      repeat.repeat, figure ? figure_text(*figure, 5) : "–",
      repeat.evaluations ? count_text(static_cast<double>(*repeat.evaluations)) : "–", seconds(repeat.to_best),
      seconds(repeat.seconds), escape_html(how));
}

std::string repeats_html(const ProblemReport& problem, const OptimizerDetail& detail) {
  const bool has_error =
      std::ranges::any_of(detail.repeats, [](const RepeatDetail& repeat) { return repeat.relative_error.has_value(); });
  std::string rows;
  for (const RepeatDetail& repeat : detail.repeats) rows += repeat_row(repeat, has_error);
  const std::string title = fmt::format("Trials of {} on {}", detail.label, problem.table.reference.label);
  return scroll(title,
                fmt::format("<table class=\"repeats\"><caption>{}</caption><thead><tr><th class=\"label\" "
                            "scope=\"col\">repeat</th><th scope=\"col\">{}</th><th "
                            "scope=\"col\">evaluations</th><th scope=\"col\">time to best</th><th "
                            "scope=\"col\">total time</th><th scope=\"col\" class=\"label\">end</th></tr></thead>"
                            "<tbody>\n{}</tbody></table>",
                            escape_html(title), has_error ? "relative error" : "quality", rows));
}

std::string claims_text(const OptimizerScrutiny& scrutiny) {
  const ClaimsSeen& claims = scrutiny.claims;
  if (claims.claiming == 0) return "it says nothing of its own result";
  if (claims.agrees())
    return fmt::format("what it says of its result in {} trials agrees with what was seen{}", claims.claiming,
                       claims.other_points > 0
                           ? fmt::format("; in {} it returns another point than its best", claims.other_points)
                           : "");
  return "what it says of its result is not what was seen: see below the table of results";
}

void add_number(std::vector<std::pair<std::string, std::string>>& facts, const char* name,
                const std::optional<double>& value) {
  if (value) facts.emplace_back(name, figure_text(*value, 2));
}

std::string facts_html(const OptimizerDetail& detail, const OptimizerScrutiny* scrutiny) {
  std::vector<std::pair<std::string, std::string>> facts;
  if (scrutiny) facts.emplace_back("claims", claims_text(*scrutiny));
  if (!detail.status.empty()) facts.emplace_back("in its own words, of its first trial", detail.status);
  if (scrutiny && scrutiny->first_to_rest)
    facts.emplace_back("time per evaluation, first repeat over the others", figure_text(*scrutiny->first_to_rest, 3));
  add_number(facts, "cost known to, at worst", detail.health.cost_error);
  add_number(facts, "drift of what the race saw, at worst", detail.health.drift);
  add_number(facts, "backward error, at worst", detail.health.residual);
  add_number(facts, "decrease left per unit of a coordinate, at worst", detail.health.stationarity);
  add_number(facts, "digits that an independent evaluation confirms, at least", detail.health.least_digits);
  if (detail.health.refused > 0)
    facts.emplace_back("evaluations without a cost, at most", std::to_string(detail.health.refused));
  for (const std::string& condition : detail.conditions) facts.emplace_back("ran on", condition);
  std::string text = "<dl>\n";
  for (const auto& [name, said] : facts)
    text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape_html(name), escape_html(said));
  return facts.empty() ? "" : text + "</dl>\n";
}

std::string on_problem(const ProblemReport& problem, const OptimizerDetail& detail, const std::string& id) {
  const auto scrutiny = std::ranges::find(problem.scrutiny.optimizers, detail.label, &OptimizerScrutiny::optimizer);
  const LineChart chart = repeats_chart(problem, detail);
  const bool drawn = std::ranges::any_of(chart.lines, [](const ChartLine& line) { return !line.points.empty(); });
  return fmt::format("<h4>On {}</h4>\n", escape_html(problem.table.reference.label)) +
         (drawn ? "<figure class=\"small\">" + svg_chart(chart, id) + "</figure>\n" : "") +
         facts_html(detail, scrutiny == problem.scrutiny.optimizers.end() ? nullptr : &*scrutiny) +
         repeats_html(problem, detail);
}

// In the order in which problems name them, each once.
std::vector<std::string> labels_of(const ReportData& data) {
  std::vector<std::string> labels;
  for (const ProblemReport& problem : data.problems)
    for (const OptimizerDetail& detail : problem.optimizers)
      if (std::ranges::find(labels, detail.label) == labels.end()) labels.push_back(detail.label);
  return labels;
}

std::string section(const ReportData& data, const std::string& label, std::size_t index) {
  std::string body;
  std::vector<DetailOn> details;
  bool differs = false;
  for (std::size_t p = 0; p < data.problems.size(); ++p) {
    const auto& all = data.problems[p].optimizers;
    const auto detail = std::ranges::find(all, label, &OptimizerDetail::label);
    if (detail == all.end()) continue;
    details.push_back({&*detail, data.problems[p].table.reference.label});
    differs = differs || std::ranges::any_of(detail->options, &OptionDetail::differs);
    body += on_problem(data.problems[p], *detail, fmt::format("repeats-{}-{}", index, p));
  }
  const OptimizerDetail* first = details.front().detail;
  return fmt::format("<details class=\"optimizer\" id=\"optimizer-{}\"><summary><h3>{}</h3>{}{}</summary>\n", index,
                     escape_html(label), first->use == label ? "" : " <code>" + escape_html(first->use) + "</code>",
                     differs ? " – ran with other options than asked for" : "") +
         (first->summary.empty() ? "" : "<p>" + escape_html(first->summary) + ".</p>\n") +
         (first->reference.empty() ? "" : "<p class=\"note\">" + escape_html(first->reference) + "</p>\n") +
         options_html(details) + body + "</details>\n";
}

}  // namespace

std::string optimizers_html(const ReportData& data) {
  const std::vector<std::string> labels = labels_of(data);
  if (labels.empty()) return {};
  std::string text =
      "<section id=\"optimizers\"><h2>Each optimizer</h2>\n<p>Every trial, how it was set, and how far its numbers and "
      "times can be trusted.</p>\n";
  for (std::size_t i = 0; i < labels.size(); ++i) text += section(data, labels[i], i);
  return text + "</section>\n";
}

}  // namespace nodal::report
