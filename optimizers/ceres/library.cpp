// SPDX-License-Identifier: GPL-3.0-or-later
#include "library.h"

#include <glog/logging.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace nodal::ceres_methods {

void silence() {
  FLAGS_minloglevel = google::GLOG_FATAL;
  FLAGS_stderrthreshold = google::GLOG_FATAL;
}

std::string in_kebab_case(std::string_view words) {
  std::string result(words);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return c == '_' ? '-' : static_cast<char>(std::tolower(c)); });
  return result;
}

std::vector<double> strictly_inside(const Space& space, std::span<const double> start) {
  std::vector<double> x(start.begin(), start.end());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double lower = space.lower()[i], upper = space.upper()[i];
    const double margin = 1e-3 * (upper - lower);
    if (x[i] <= lower) x[i] = lower + margin;
    if (x[i] >= upper) x[i] = upper - margin;
  }
  return x;
}

void judge(Outcome& outcome, const Watch& watch, ::ceres::TerminationType type, const std::string& message) {
  outcome.reason = message;
  outcome.limited = type == ::ceres::NO_CONVERGENCE;
  if (watch.over() || watch.lowered()) return;
  outcome.failed = type == ::ceres::FAILURE;
  outcome.reason += "; no step lowered the cost";
}

Claim make_claim(::ceres::TerminationType type, double cost, std::vector<double> x,
                 std::optional<std::int64_t> evaluations) {
  Claim claim;
  claim.status = ::ceres::TerminationTypeToString(type);
  claim.evaluations = evaluations;
  if (type == ::ceres::FAILURE || type == ::ceres::USER_FAILURE) return claim;
  claim.cost = cost;
  claim.x = std::move(x);
  return claim;
}

}  // namespace nodal::ceres_methods
