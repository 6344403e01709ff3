// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/show/html.h>
#include <nodal/shown.h>

#include "page_parts.h"
#include "report.h"

namespace nodal::report {

namespace {

constexpr std::size_t kFewTies = 3;  // on a terminal

std::string cell(const std::string& text) { return "<td>" + escape_html(text) + "</td>"; }

// Two columns, so that a phone has room for them: what to take with what, and all there is to say of it.
std::string rows_html(std::span<const Verdict> verdicts, const Scope& scope, const std::string& name) {
  std::string text =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Which to take\"><table class=\"answer\">"
      "<thead><tr><th scope=\"col\" class=\"label\">with</th><th scope=\"col\" class=\"label\">take</th></tr></thead>\n"
      "<tbody>\n";
  for (const AnswerRow& row : answer_rows(verdicts, scope, name)) {
    text += fmt::format("<tr><th scope=\"row\">{}</th><td><b>{}</b>", escape_html(row.limits), escape_html(row.take));
    for (const auto& [word, value] : {std::pair("", &row.value), {"ties: ", &row.ties}, {"next: ", &row.next}})
      if (!value->empty()) text += fmt::format("<br>{}{}", word, escape_html(*value));
    text += "</td></tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string ranks_html(const Answer& answer) {
  const Verdict& last = answer.verdicts.back();
  if (last.problems.size() < 2 || last.standings.empty()) return {};
  std::string text =
      "<details><summary>Mean ranks over problems</summary>\n<div class=\"scroll\" tabindex=\"0\" "
      "role=\"region\" aria-label=\"Mean ranks over problems\"><table class=\"plain\"><thead><tr><th "
      "scope=\"col\">optimizer</th>";
  for (const Verdict& verdict : answer.verdicts)
    text += "<th scope=\"col\">" + escape_html(limit_text(verdict.limit, answer.scope)) + "</th>";
  text += "</tr></thead><tbody>\n";
  for (const Standing& standing : last.standings) {
    text += "<tr><th scope=\"row\">" + escape_html(standing.optimizer) + "</th>";
    for (const Verdict& verdict : answer.verdicts) {
      const auto here = std::ranges::find(verdict.standings, standing.optimizer, &Standing::optimizer);
      text += cell(here == verdict.standings.end() ? "–" : fmt::format("{:.2f}", here->rank));
    }
    text += "</tr>\n";
  }
  text += "<tr><th scope=\"row\">Friedman's test: all rank alike</th>";
  for (const Verdict& verdict : answer.verdicts) text += cell(verdict.friedman_p ? p_text(*verdict.friedman_p) : "–");
  return text + "</tr>\n</tbody></table></div></details>\n";
}

}  // namespace

std::string common_quality_name(const ReportData& data) {
  const std::string name = data.problems.empty() ? "quality" : data.problems.front().raced_name();
  return std::ranges::all_of(data.problems, [&](const ProblemReport& problem) { return problem.raced_name() == name; })
             ? name
             : "quality";
}

std::string answer_lines(const ReportData& data) {
  if (data.answer.empty()) return {};
  std::string text = "Which to take\n";
  for (const AnswerRow& row : answer_rows(data.answer.verdicts, data.answer.scope, common_quality_name(data), kFewTies))
    text += "  " + printable(row.sentence()) + "\n";
  for (const std::string& line : scope_lines(data.answer)) text += "  " + printable(line) + "\n";
  return text + "\n";
}

std::string answer_html(const ReportData& data) {
  const Answer& answer = data.answer;
  if (answer.empty()) return {};
  std::string text = "<section class=\"answer\">\n<h2>Which to take</h2>\n";
  text += rows_html(answer.verdicts, answer.scope, common_quality_name(data));
  for (const std::string& line : scope_lines(answer)) text += "<p class=\"note\">" + escape_html(line) + "</p>\n";
  if (!answer.verdicts.back().partial.empty())
    text += "<p class=\"note\">" +
            escape_html(fmt::format("Have not tried every problem, and are left out: {}.",
                                    fmt::join(answer.verdicts.back().partial, ", "))) +
            "</p>\n";
  for (const ProblemAnswer& of : answer.problems) {
    const auto problem = std::ranges::find_if(
        data.problems, [&](const ProblemReport& p) { return p.table.reference.label == of.problem; });
    text += "<details><summary>On " + escape_html(of.problem) + " alone</summary>\n" +
            rows_html(of.verdicts, answer.scope, problem == data.problems.end() ? "quality" : problem->raced_name()) +
            "</details>\n";
  }
  text += ranks_html(answer) + "<details><summary>How this is decided</summary>\n<ul>\n";
  for (const std::string& line : answer_legend(answer)) text += "<li>" + escape_html(line) + "</li>\n";
  return text + "</ul></details>\n</section>\n";
}

}  // namespace nodal::report
