// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/verify.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <nodal/agreement.h>
#include <nodal/shown.h>

#include "trial_audit.h"

namespace nodal {

namespace {

constexpr std::int64_t kThinned = 2000;  // improvements: a trace of as many evaluations may have fewer points

bool near(double a, double b, double tolerance) {
  return a == b || std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

// Two figures of one record, of which one is refined. Near a perfect fit only their accuracy counts.
bool agrees(const std::optional<double>& told, double seen, double drift) {
  return !told || near(*told, seen, std::max(drift, kLargestContradiction)) || std::abs(*told - seen) <= kRaceAccuracy;
}

// One build counts evaluations and seconds as another does.
bool may_be_ended_by_the_clock(const TrialRecord& record, bool timed) {
  if (record.end == End::timeout) return true;
  return timed && (record.end == End::failed || (record.end == End::budget && record.reason != kEvaluationsSpent));
}

// Under a validated stop the trace ends where that is.
std::int64_t end_of_trace(const TrialRecord& record) {
  return record.unseen && record.unseen->stop ? record.unseen->stop->evaluation : record.counts.evaluations;
}

std::string text_of(const Value* value) {
  if (!value) return "not there";
  return value->is_number() ? fmt::format("{}", value->number()) : beginning(to_json(*value), 60);
}

// The first entry that differs, "best.cost was 1, now it is 2"; empty when there is none.
std::string first_difference(const Value* then, const Value* now, const std::string& name) {
  if (then && now && then->is_table() && now->is_table()) {
    const std::string within = name.empty() ? "" : name + ".";
    for (const auto& [key, value] : then->table())
      if (std::string found = first_difference(&value, now->find(key), within + key); !found.empty()) return found;
    for (const auto& [key, value] : now->table())
      if (!then->find(key)) return first_difference(nullptr, &value, within + key);
    return {};
  }
  if (then && now && to_json(*then) == to_json(*now)) return {};
  return fmt::format("{} was {}, now it is {}", name, text_of(then), text_of(now));
}

Value comparable(TrialRecord record) {
  record.attempt = 1;
  return parse_json(to_json_line(untimed(std::move(record))), "record");
}

class Comparing {
 public:
  Comparing(const TrialRecord& stored, const TrialRecord& again, double tolerance, bool timed)
      : stored_(stored),
        again_(again),
        tolerance_(tolerance),
        stored_clocked_(may_be_ended_by_the_clock(stored, timed)),
        again_clocked_(may_be_ended_by_the_clock(again, timed)) {
    result_.evaluations = std::min(end_of_trace(stored), end_of_trace(again));
  }

  SameTrial run() {
    if (is_failure(again_.end) != is_failure(stored_.end))
      differ(fmt::format("it {}, now it {}", ending(stored_), ending(again_)));
    look_at_stored();
    compare_summaries(stored_.start, again_.start, "start");
    compare_traces();
    compare_lengths();
    if (result_.difference.empty() && equally_far()) compare_rest();
    const bool whole = equally_far() && !clocked();
    const bool way = result_.points > 1 || (result_.evaluations > 0 && lacking_ == 0);
    result_.checked = !result_.difference.empty() || whole || way;
    return std::move(result_);
  }

 private:
  static std::string ending(const TrialRecord& record) {
    return fmt::format("ended '{}'{}{}", to_string(record.end), record.reason.empty() ? "" : ": ", record.reason);
  }

  bool equally_far() const { return stored_.counts.evaluations == again_.counts.evaluations; }
  // Of two that the clock ended at one evaluation, what that found may count in one only.
  bool end_alike() const {
    return !stored_.trace.empty() && !again_.trace.empty() &&
           stored_.trace.back().evaluation == again_.trace.back().evaluation;
  }
  bool clocked() const { return stored_clocked_ || again_clocked_; }
  bool thinned() const {
    return !equally_far() && std::max(stored_.counts.evaluations, again_.counts.evaluations) >= kThinned;
  }

  void differ(std::string what) {
    if (result_.difference.empty()) result_.difference = std::move(what);
  }

  void look_at_stored() {
    const std::vector<TracePoint>& trace = stored_.trace;
    const std::int64_t evaluations = stored_.counts.evaluations;
    if (trace.empty()) return;
    if (trace.back().evaluation > evaluations)
      differ(fmt::format("the record has {} evaluations, and a point at evaluation {}", evaluations,
                         trace.back().evaluation));
    if (!stored_.best) return;
    const BestPoint& best = *stored_.best;
    if (best.evaluation != trace.back().evaluation)
      differ(fmt::format("the record has its best from evaluation {}, its trace ends at {}", best.evaluation,
                         trace.back().evaluation));
    if (!agrees(best.summary.quality, trace.back().quality, stored_.health.drift.value_or(0.0)))
      differ(fmt::format("the record has a best of quality {}, its trace ends at {}", *best.summary.quality,
                         trace.back().quality));
  }

  void compare_traces() {
    auto a = stored_.trace.begin(), b = again_.trace.begin();
    const auto within = [this](const auto& at, const auto& trace) {
      return at != trace.end() && at->evaluation <= result_.evaluations;
    };
    while (result_.difference.empty() && (within(a, stored_.trace) || within(b, again_.trace))) {
      const bool both = within(a, stored_.trace) && within(b, again_.trace);
      if (both && a->evaluation == b->evaluation) {
        ++result_.points;
        if (!near(a->quality, b->quality, tolerance_))
          differ(
              fmt::format("at evaluation {} the quality was {}, now it is {}", a->evaluation, a->quality, b->quality));
        ++a, ++b;
        continue;
      }
      const bool first = both ? a->evaluation < b->evaluation : within(a, stored_.trace);
      if (first ? !may_lack(again_, b, again_clocked_, *a) : !may_lack(stored_, a, stored_clocked_, *b))
        differ(fmt::format("a better point at evaluation {} was found {} only", first ? a->evaluation : b->evaluation,
                           first ? "then" : "now"));
      ++lacking_;
      first ? ++a : ++b;
    }
  }

  // What was found by the evaluation during which the clock ran out doesn't count. What thinning has removed lies
  // between two that were kept, in quality, too.
  bool may_lack(const TrialRecord& record, std::vector<TracePoint>::const_iterator next, bool clocked,
                const TracePoint& point) const {
    if (clocked && point.evaluation == record.counts.evaluations) return true;
    if (!thinned() || next == record.trace.begin() || next == record.trace.end()) return false;
    const double room = tolerance_ * std::abs(point.quality);
    return std::prev(next)->quality >= point.quality - room && point.quality + room >= next->quality;
  }

  void compare_lengths() {
    const bool stored_shorter = stored_.counts.evaluations < again_.counts.evaluations;
    if (equally_far() || (stored_shorter ? stored_clocked_ : again_clocked_)) return;
    differ(fmt::format("it ended after {} evaluations, now after {}", stored_.counts.evaluations,
                       again_.counts.evaluations));
  }

  // Where the clock ended one of two that went equally far, the other may have been given a derivative more.
  void compare_rest() {
    if (stored_.end != again_.end) differ(fmt::format("it {}, now it {}", ending(stored_), ending(again_)));
    if (tolerance_ > 0.0 || clocked()) {
      if (!clocked() || end_alike()) compare_bests();
      if (!clocked()) compare_counts();
    } else {
      const Value then = comparable(stored_), now = comparable(again_);
      if (std::string found = first_difference(&then, &now, ""); !found.empty()) differ(std::move(found));
    }
  }

  void compare_bests() {
    if (stored_.best.has_value() != again_.best.has_value())
      differ(stored_.best ? "it had a best point, now it has none" : "it had no best point, now it has one");
    if (!stored_.best || !again_.best) return;
    compare_summaries(stored_.best->summary, again_.best->summary, "best");
    if (stored_.best->evaluation != again_.best->evaluation)
      differ(fmt::format("the best was found at evaluation {}, now at {}", stored_.best->evaluation,
                         again_.best->evaluation));
    if (tolerance_ == 0.0 && stored_.best->x != again_.best->x)
      differ("the best point is another one of the same quality");
  }

  // Older records lack some.
  void compare_summaries(const PointSummary& then, const PointSummary& now, const char* of) {
    const auto compare = [&](const char* name, const std::optional<double>& a, const std::optional<double>& b) {
      if (!a || !b || near(*a, *b, tolerance_) || (tolerance_ > 0.0 && std::abs(*a - *b) <= kPerfectCost)) return;
      differ(fmt::format("{}.{} was {}, now it is {}", of, name, *a, *b));
    };
    compare("cost", then.cost, now.cost);
    compare("quality", then.quality, now.quality);
    compare("relative_error", then.relative_error, now.relative_error);
    compare("data_quality", then.data_quality, now.data_quality);
  }

  void compare_counts() {
    const auto compare = [&](const char* name, std::int64_t then, std::int64_t now) {
      if (then != now) differ(fmt::format("counts.{} was {}, now it is {}", name, then, now));
    };
    const Counts &then = stored_.counts, &now = again_.counts;
    compare("values", then.values, now.values);
    compare("gradients", then.gradients, now.gradients);
    compare("residuals", then.residuals, now.residuals);
    compare("jacobians", then.jacobians, now.jacobians);
    compare("products", then.products, now.products);
    compare("proposed", then.proposed, now.proposed);
    compare("accepted", then.accepted, now.accepted);
  }

  const TrialRecord& stored_;
  const TrialRecord& again_;
  double tolerance_;
  bool stored_clocked_, again_clocked_;
  std::int64_t lacking_ = 0;  // points that one trace has only
  SameTrial result_;
};

}  // namespace

TrialRecord untimed(TrialRecord record) {
  record.seconds = {};
  record.conditions.reset();
  for (TracePoint& point : record.trace) point.seconds = 0.0;
  if (record.unseen)
    for (UnseenPoint& point : record.unseen->points) point.at.seconds = 0.0;
  return record;
}

SameTrial same_trial(const TrialRecord& stored, const TrialRecord& again, double tolerance, bool timed) {
  return Comparing(stored, again, tolerance, timed).run();
}

}  // namespace nodal
