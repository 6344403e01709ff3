// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/show/html.h>
#include <nodal/show/number_text.h>

#include "page_parts.h"

namespace nodal::report {

namespace {

constexpr std::array<Axis, 3> kAxes = {Axis::seconds, Axis::evaluations, Axis::work};

// Digits that no chart can show only make the page large. Qualities need more than positions: near G* the gap is what
// remains of them.
constexpr int kPositionDigits = 5, kQualityDigits = 12;

// What lies beyond was never measured, and powers of it overflow on the way to an axis.
constexpr double kLargest = 1e100;
bool sane(double value) { return std::abs(value) <= kLargest; }

bool drawable(const CurvePoint& p) {
  return sane(p.position) && p.position >= 1.0 / kLargest && sane(p.quality.lower) && sane(p.quality.median) &&
         sane(p.quality.upper);
}

// A logarithmic axis has no place for zero.
std::vector<const CurvePoint*> drawable_points(const std::vector<CurvePoint>& curve) {
  std::vector<const CurvePoint*> points;
  for (const CurvePoint& p : curve)
    if (drawable(p)) points.push_back(&p);
  return points;
}

Value column(const std::vector<const CurvePoint*>& points, int digits, double (*get)(const CurvePoint&)) {
  Value::List numbers;
  for (const CurvePoint* p : points) numbers.push_back(rounded(get(*p), digits));
  return numbers;
}

Value curve_value(const std::vector<CurvePoint>& curve) {
  const std::vector<const CurvePoint*> points = drawable_points(curve);
  Value value;
  value.set("x", column(points, kPositionDigits, [](const CurvePoint& p) { return p.position; }));
  value.set("lower", column(points, kQualityDigits, [](const CurvePoint& p) { return p.quality.lower; }));
  value.set("median", column(points, kQualityDigits, [](const CurvePoint& p) { return p.quality.median; }));
  value.set("upper", column(points, kQualityDigits, [](const CurvePoint& p) { return p.quality.upper; }));
  return value;
}

// Problems that count no flops have work = evaluations: one axis less to choose from.
bool work_is_evaluations(const std::vector<OptimizerCurves>& curves) {
  return std::ranges::all_of(curves, [](const OptimizerCurves& c) {
    return std::ranges::equal(c.by_axis[static_cast<std::size_t>(Axis::evaluations)],
                              c.by_axis[static_cast<std::size_t>(Axis::work)], {}, &CurvePoint::position,
                              &CurvePoint::position);
  });
}

Value series_value(const OptimizerCurves& curves, std::span<const Axis> axes, const ProblemTable& table) {
  const auto row = std::ranges::find(table.rows, curves.optimizer, &OptimizerRow::label);
  Value value;
  value.set("label", curves.optimizer);
  value.set("baseline", row != table.rows.end() && row->baseline);
  for (const Axis axis : axes) value.set(to_string(axis), curve_value(curves.by_axis[static_cast<std::size_t>(axis)]));
  return value;
}

Value series_list(const std::vector<OptimizerCurves>& curves, std::span<const Axis> axes, const ProblemTable& table) {
  Value::List series;
  for (const OptimizerCurves& one : curves) series.push_back(series_value(one, axes, table));
  return Value(std::move(series));
}

Value axes_list(std::span<const Axis> axes) {
  Value::List names;
  for (const Axis axis : axes) names.emplace_back(to_string(axis));
  return Value(std::move(names));
}

// What the curves show where no gaps are asked for.
std::string height_title(const ProblemReport& problem) {
  if (problem.error_per_quality) return "relative error";
  return problem.table.has_prior ? problem.raced_name() : "quality";
}

Value race_value(const ProblemReport& problem, std::span<const Axis> axes) {
  Value value;
  const ProblemReference& reference = problem.table.reference;
  value.set("axes", axes_list(axes));
  if (sane(reference.best_quality)) value.set("best", reference.best_quality);
  value.set("provisional", reference.provisional);
  value.set("quality", problem.raced_name());
  if (problem.table.has_prior) value.set("title", height_title(problem));
  // A start at G* has no gap to be measured in.
  const bool has_gaps = !problem.table.start_is_best && !reference.unimproved;
  if (const auto& start = problem.table.start_quality; start && sane(*start) && has_gaps) value.set("start", *start);
  if (problem.error_per_quality && sane(*problem.error_per_quality))
    value.set("errorPerQuality", *problem.error_per_quality);
  value.set("series", series_list(problem.curves, axes, problem.table));
  return value;
}

Value unseen_value(const ProblemReport& problem, std::span<const Axis> axes) {
  Value value;
  value.set("axes", axes_list(axes));
  value.set("title", unseen_finding().title);
  value.set("series", series_list(problem.unseen_curves, axes, problem.table));
  return value;
}

std::string radio(const char* chart, std::size_t index, const char* group, const char* value, const char* label,
                  bool checked) {
  return fmt::format(R"(<label><input type="radio" name="{}-{}-{}" data-{}="{}"{}> {}</label>)", chart, index, group,
                     group, value, checked ? " checked" : "", label);
}

std::string axis_controls(const char* chart, std::size_t index, std::span<const Axis> axes) {
  std::string text = "<fieldset><legend>Against</legend>";
  for (const Axis axis : axes) {
    const char* label = axis == Axis::seconds ? "time" : axis == Axis::evaluations ? "evaluations" : "work";
    text += radio(chart, index, "axis", std::string(to_string(axis)).c_str(), label, axis == axes.front());
  }
  return text + "</fieldset>";
}

std::string height_controls(const ProblemReport& problem, const char* chart, std::size_t index) {
  return "<fieldset><legend>Show</legend>" +
         radio(chart, index, "height", "error", height_title(problem).c_str(), true) +
         radio(chart, index, "height", "gap", ("gap to " + problem.raced_name() + "*").c_str(), false) + "</fieldset>";
}

std::string figure_html(const char* chart, std::size_t index, const std::string& controls, const std::string& caption,
                        const Value& data) {
  return fmt::format(
      "<figure class=\"race\" id=\"{}-{}\">\n<div class=\"controls\">{}</div>\n<div class=\"chart\"></div>\n"
      "<div class=\"keys\" role=\"group\" aria-label=\"Optimizers shown\"></div>\n<figcaption>{} Choose an optimizer "
      "below the chart to hide or show its line.</figcaption>\n<script type=\"application/json\" "
      "class=\"race-data\">{}</script>\n</figure>\n",
      chart, index, controls, escape_html(caption), escape_script(to_json(data)));
}

std::span<const Axis> axes_of(const ProblemReport& problem) {
  return std::span(kAxes).first(work_is_evaluations(problem.curves) ? 2 : 3);
}

}  // namespace

std::string chart_html(const ProblemReport& problem, std::size_t index) {
  if (problem.curves.empty()) return {};
  const std::span<const Axis> axes = axes_of(problem);
  return figure_html("race", index, axis_controls("race", index, axes) + height_controls(problem, "race", index),
                     "Median over trials; the band holds the middle half of them.", race_value(problem, axes));
}

std::string unseen_chart_html(const ProblemReport& problem, std::size_t index) {
  if (problem.unseen_curves.empty() || !problem.table.unseen) return {};
  const std::span<const Axis> axes = axes_of(problem);
  return "<h3>What is held out</h3>\n" +
         figure_html(
             "unseen", index, axis_controls("unseen", index, axes),
             fmt::format(
                 "Unseen error of the best point so far: root mean square of the relative errors in "
                 "{}, which no optimizer sees. Median over trials; the band holds the middle half.{}",
                 fmt::join(problem.table.unseen->reported, ", "),
                 problem.table.unseen->chosen_by.empty() ? "" : " Lines go on beyond the points that are reported."),
             unseen_value(problem, axes));
}

}  // namespace nodal::report
