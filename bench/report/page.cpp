// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include <nodal/show/html.h>
#include <nodal/show/number_text.h>

#include "chart/line_styles.h"
#include "counted.h"
#include "page_parts.h"
#include "report.h"
#include "table.h"

namespace nodal::report {

namespace {

std::string paragraph(const std::string& text) { return "<p>" + escape_html(text) + "</p>\n"; }

std::string headline(const ReportData& data) {
  std::size_t trials = 0;
  std::set<std::string> optimizers;
  for (const ProblemReport& problem : data.problems)
    for (const OptimizerRow& row : problem.table.rows) {
      optimizers.insert(row.label);
      trials += row.trials;
    }
  return fmt::format("<h1>{}</h1>\n<p>{} on {}, {}. Which gets how close, how fast?</p>\n",
                     escape_html(data.study_name.empty() ? "Comparison" : data.study_name),
                     counted(optimizers.size(), "optimizer", "optimizers"),
                     counted(data.problems.size(), "problem", "problems"), counted(trials, "trial", "trials"));
}

std::string warnings_html(const ReportData& data) {
  if (data.warnings.empty()) return {};
  std::string text = "<section class=\"warnings\"><h2>Warnings</h2><ul>\n";
  for (const std::string& warning : data.warnings) text += "<li>" + escape_html(warning) + "</li>\n";
  return text + "</ul></section>\n";
}

std::string problem_html(const ReportData& data, std::size_t index) {
  const ProblemReport& problem = data.problems[index];
  const auto pictures = data.pictures.find(problem.table.reference.label);
  return fmt::format("<section class=\"problem\" id=\"problem-{}\">\n<h2>", index) +
         escape_html(problem.table.reference.label) + "</h2>\n" + paragraph(describe_reference(problem) + ".") +
         chart_html(problem, index) + table_html(problem) + ends_html(problem.ends, problem.raced_name()) +
         unseen_chart_html(problem, index) + (pictures == data.pictures.end() ? std::string() : pictures->second.html) +
         problem.details.html + "</section>\n";
}

// What stands on the page, for those who look for one thing.
std::string contents(const ReportData& data) {
  std::string text = "<nav aria-label=\"Contents\"><ul>\n";
  for (std::size_t i = 0; i < data.problems.size(); ++i)
    text += fmt::format("<li><a href=\"#problem-{}\">{}</a></li>\n", i,
                        escape_html(data.problems[i].table.reference.label));
  if (std::ranges::any_of(data.problems, [](const ProblemReport& p) { return !p.optimizers.empty(); }))
    text += "<li><a href=\"#optimizers\">Each optimizer</a></li>\n";
  return text +
         "<li><a href=\"#how-to-read\">How to read this</a></li>\n<li><a href=\"#provenance\">Where this comes "
         "from</a></li>\n</ul></nav>\n";
}

std::string how_to_read(const ReportData& data) {
  std::string text = "<section id=\"how-to-read\"><h2>How to read this</h2>\n<ul>\n";
  for (const std::string& sentence : table_legend(data.problems)) text += "<li>" + escape_html(sentence) + "</li>\n";
  text +=
      "<li>Quartiles: a quarter of the trials ended below the first figure, a quarter above the second.</li>\n"
      "<li>An evaluation is one cost seen at one point; a derivative at that point is counted as work only.</li>\n"
      "<li>Flops are told in equivalent full values, \"work\" in the records: the arithmetic of the trial over that of "
      "one full evaluation. Factorizations are numeric ones.</li>\n";
  return text + "</ul></section>\n";
}

std::string failures_html(const ReportData& data) {
  if (data.failed.empty() && data.left_out.empty()) return {};
  std::string text;
  if (!data.failed.empty()) {
    text +=
        "<section><h2>Trials that failed</h2>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
        "aria-label=\"Trials that failed\"><table class=\"plain\"><thead><tr><th "
        "scope=\"col\">problem</th><th scope=\"col\">optimizer</th><th scope=\"col\">repeat</th><th "
        "scope=\"col\">end</th><th scope=\"col\">reason</th></tr></thead><tbody>\n";
    for (const FailedTrial& t : data.failed)
      text += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                          escape_html(t.problem), escape_html(t.optimizer), t.repeat, to_string(t.end),
                          escape_html(t.reason));
    text += "</tbody></table></div></section>\n";
  }
  if (!data.left_out.empty()) {
    text += "<section><h2>Left out of this build</h2>\n<ul>\n";
    for (const LeftOut& entry : data.left_out)
      text += fmt::format("<li>{} (<code>{}</code>): {}</li>\n", escape_html(entry.label), escape_html(entry.use),
                          escape_html(entry.reason));
    text += "</ul></section>\n";
  }
  return text;
}

// What the parts of a page need, each text once.
std::vector<std::string> needed_by_parts(const ReportData& data, std::string ReportPart::*member) {
  std::vector<std::string> texts;
  const auto add = [&](const ReportPart& part) {
    const std::string& text = part.*member;
    if (!part.empty() && !text.empty() && std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
  };
  for (const ProblemReport& problem : data.problems) {
    if (const auto found = data.pictures.find(problem.table.reference.label); found != data.pictures.end())
      add(found->second);
    add(problem.details);
  }
  return texts;
}

std::string scripts_html(const ReportData& data) {
  const std::vector<std::string> of_parts = needed_by_parts(data, &ReportPart::script);
  const bool races = std::ranges::any_of(data.problems, [](const ProblemReport& p) { return !p.curves.empty(); });
  if (!races && of_parts.empty()) return {};
  std::string text = "<script>\n";
  text += vega_js();
  text += "</script>\n<script>\n";
  text += charts_js();
  text += report_js();
  text += tables_js();
  for (const std::string& script : of_parts) text += script;
  return text + "</script>\n";
}

}  // namespace

std::string report_html(const ReportData& data) {
  std::string body = answer_html(data) + warnings_html(data);
  for (std::size_t i = 0; i < data.problems.size(); ++i) body += problem_html(data, i);
  body +=
      convergence_html(data) + optimizers_html(data) + how_to_read(data) + failures_html(data) + provenance_html(data);
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      escape_html(data.study_name.empty() ? "nodal" : data.study_name + " – nodal") + "</title>\n<style>\n";
  page += report_css();
  page += line_styles_css();
  for (const std::string& style : needed_by_parts(data, &ReportPart::style)) page += style;
  page += "</style>\n</head>\n<body>\n<a class=\"skip\" href=\"#results\">Skip to the results</a>\n<header>\n" +
          headline(data) + contents(data) + "</header>\n<main id=\"results\">\n" + body + "</main>\n";
  return page + scripts_html(data) + "</body>\n</html>\n";
}

}  // namespace nodal::report
