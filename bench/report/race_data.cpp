// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <nodal/show/number_text.h>

#include "chart/line_styles.h"
#include "race_chart.h"

namespace nodal::report {

namespace {

// Digits that no chart can show only make the page large. Qualities need more than positions: near G* the gap is what
// remains of them.
constexpr int kPositionDigits = 5, kQualityDigits = 12, kErrorDigits = 5;

bool sane(double value) { return std::abs(value) <= kLargestDrawn; }

bool can_be_drawn(const CurvePoint& p) {
  return sane(p.position) && p.position >= 1.0 / kLargestDrawn && sane(p.quality.lower) && sane(p.quality.median) &&
         sane(p.quality.upper);
}

// A logarithmic axis has no place for zero.
std::vector<const CurvePoint*> drawn_points(const std::vector<CurvePoint>& curve) {
  std::vector<const CurvePoint*> points;
  for (const CurvePoint& p : curve)
    if (can_be_drawn(p)) points.push_back(&p);
  return points;
}

Value column(const std::vector<const CurvePoint*>& points, int digits, double (*get)(const CurvePoint&)) {
  Value::List numbers;
  for (const CurvePoint* p : points) numbers.push_back(rounded(get(*p), digits));
  return numbers;
}

bool has_spread(const CurvePoint* p) {
  return p->quality.lower != p->quality.median || p->quality.upper != p->quality.median;
}

// Trials that all did the same have no band to speak of, and many rows are of such: it is left out.
Value curve_value(const std::vector<CurvePoint>& curve, int digits) {
  const std::vector<const CurvePoint*> points = drawn_points(curve);
  Value value;
  value.set("x", column(points, kPositionDigits, [](const CurvePoint& p) { return p.position; }));
  value.set("median", column(points, digits, [](const CurvePoint& p) { return p.quality.median; }));
  if (std::ranges::none_of(points, has_spread)) return value;
  value.set("lower", column(points, digits, [](const CurvePoint& p) { return p.quality.lower; }));
  value.set("upper", column(points, digits, [](const CurvePoint& p) { return p.quality.upper; }));
  return value;
}

Value dash_value(std::string_view dash) {
  Value::List lengths;
  while (!dash.empty()) {
    lengths.emplace_back(dash[0] - '0');
    dash.remove_prefix(std::min<std::size_t>(dash.size(), 2));
  }
  return lengths;
}

Value series_value(const OptimizerCurves& curves, std::span<const Axis> axes, const ProblemReport& problem,
                   int digits) {
  const ChartLine line = line_named(problem, curves.optimizer);
  const LineStyle style = line.baseline ? baseline_style() : line_style(line.style);
  Value value;
  value.set("label", curves.optimizer);
  value.set("baseline", line.baseline);
  value.set("colour", style.light);
  value.set("dark", style.dark);
  value.set("dash", dash_value(style.dash));
  for (const Axis axis : axes)
    value.set(to_string(axis), curve_value(curves.by_axis[static_cast<std::size_t>(axis)], digits));
  return value;
}

Value axes_value(std::span<const Axis> axes) {
  Value::List list;
  for (const Axis axis : axes) {
    Value one;
    one.set("name", to_string(axis));
    one.set("title", axis_title(axis));
    list.push_back(std::move(one));
  }
  return list;
}

// What gaps are made by, and the line of the best known.
void set_reference(const ProblemReport& problem, Value& value) {
  const ProblemReference& reference = problem.table.reference;
  if (sane(reference.best_quality)) value.set("best", reference.best_quality);
  value.set("provisional", reference.provisional);
  if (has_gap(problem) && sane(*problem.table.start_quality)) value.set("start", *problem.table.start_quality);
  value.set("gapTitle", height_title(problem, Raced::gap));
  if (problem.error_per_quality && sane(*problem.error_per_quality))
    value.set("errorPerQuality", *problem.error_per_quality);
}

}  // namespace

Value race_data(const ProblemReport& problem, Raced raced) {
  const std::vector<Axis>& axes = problem.table.axes;
  const bool unseen = raced == Raced::unseen;
  Value value;
  value.set("name", race_chart(problem, raced, Axis::seconds).title);
  value.set("axes", axes_value(axes));
  value.set("title", height_title(problem, raced));
  if (!unseen) set_reference(problem, value);
  Value::List series;
  for (const OptimizerCurves& curves : unseen ? problem.unseen_curves : problem.curves)
    series.push_back(series_value(curves, axes, problem, unseen ? kErrorDigits : kQualityDigits));
  value.set("series", Value(std::move(series)));
  return value;
}

}  // namespace nodal::report
