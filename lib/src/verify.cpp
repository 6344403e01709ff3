// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/verify.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace nodal {

namespace {

constexpr std::size_t kThinned = 1500;  // a trace as long may have been: run_trial keeps at most 2000 points

bool near(double a, double b, double tolerance) {
  return a == b || std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

class Comparing {
 public:
  Comparing(const TrialRecord& stored, const TrialRecord& again, double tolerance)
      : stored_(stored), again_(again), tolerance_(tolerance) {
    result_.evaluations = std::min(stored.counts.evaluations, again.counts.evaluations);
  }

  SameTrial run() {
    if (is_failure(again_.end) != is_failure(stored_.end))
      differ(fmt::format("it {}, now it {}", ending(stored_), ending(again_)));
    compare_traces();
    if (result_.difference.empty() && equally_far()) compare_ends();
    return std::move(result_);
  }

 private:
  static std::string ending(const TrialRecord& record) {
    return fmt::format("ended '{}'{}{}", to_string(record.end), record.reason.empty() ? "" : ": ", record.reason);
  }

  bool equally_far() const { return stored_.counts.evaluations == again_.counts.evaluations; }

  void differ(std::string what) {
    if (result_.difference.empty()) result_.difference = std::move(what);
  }

  void compare_traces() {
    const bool thinned = !equally_far() && std::max(stored_.trace.size(), again_.trace.size()) >= kThinned;
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
      if (!thinned)
        differ(fmt::format("a better point at evaluation {} was found {} only", first ? a->evaluation : b->evaluation,
                           first ? "then" : "now"));
      first ? ++a : ++b;
    }
  }

  void compare_ends() {
    if (stored_.end != again_.end) differ(fmt::format("it {}, now it {}", ending(stored_), ending(again_)));
    if (!stored_.best || !again_.best || tolerance_ > 0.0) return;
    if (stored_.best->x != again_.best->x) differ("the best point is another one of the same quality");
  }

  const TrialRecord& stored_;
  const TrialRecord& again_;
  double tolerance_;
  SameTrial result_;
};

}  // namespace

SameTrial same_trial(const TrialRecord& stored, const TrialRecord& again, double tolerance) {
  return Comparing(stored, again, tolerance).run();
}

}  // namespace nodal
