// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/analysis.h>

#include <algorithm>
#include <cmath>

namespace nodal {

namespace {

// One trial read along the axis: positions ascend over calls, so the walk is linear in the trace.
class TraceWalk {
 public:
  TraceWalk(const TrialRecord& record, Axis axis) : record_(record), axis_(axis) {}

  // Best quality at a position; empty before the first point of the trace.
  std::optional<double> at(double where) {
    const std::vector<TracePoint>& trace = record_.trace;
    while (next_ < trace.size() && position(record_, trace[next_], axis_) <= where) ++next_;
    return next_ == 0 ? std::nullopt : std::optional(trace[next_ - 1].quality);
  }

 private:
  const TrialRecord& record_;
  Axis axis_;
  std::size_t next_ = 0;
};

// The axis is logarithmic: evaluation 0 and second 0 stand at its left end.
double left_end(std::span<const TrialRecord* const> trials, Axis axis) {
  if (axis != Axis::seconds) return 1.0;
  std::vector<double> first;
  for (const TrialRecord* trial : trials)
    if (!trial->trace.empty()) first.push_back(position(*trial, trial->trace.front(), axis));
  const std::optional<Quartiles> q = quartiles(std::move(first));
  return q ? std::max(q->median, 1e-7) : 0.0;
}

double right_end(std::span<const TrialRecord* const> trials, Axis axis) {
  double last = 0.0;
  for (const TrialRecord* trial : trials) last = std::max(last, end_position(*trial, axis));
  return last;
}

}  // namespace

std::vector<CurvePoint> make_curve(std::span<const TrialRecord* const> trials, Axis axis, std::size_t points) {
  std::vector<CurvePoint> curve;
  const double left = left_end(trials, axis), right = right_end(trials, axis);
  if (points < 2 || left <= 0.0 || right < left) return curve;
  std::vector<TraceWalk> walks;
  for (const TrialRecord* trial : trials) walks.emplace_back(*trial, axis);
  for (std::size_t i = 0; i < points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(points - 1);
    const double where = i + 1 == points ? right : left * std::pow(right / left, share);
    std::vector<double> qualities;
    for (TraceWalk& walk : walks)
      if (const std::optional<double> quality = walk.at(where)) qualities.push_back(*quality);
    // With fewer than half of the trials on the way, the median would be that of the quick ones.
    if (2 * qualities.size() < trials.size()) continue;
    if (const std::optional<Quartiles> q = quartiles(std::move(qualities))) curve.push_back({where, *q});
  }
  return curve;
}

}  // namespace nodal
