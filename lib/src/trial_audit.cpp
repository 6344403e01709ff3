// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial_audit.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include <fmt/format.h>

#include <nodal/agreement.h>

#include "record_archive.h"

namespace nodal {

void TrialAudit::fail(const std::string& what) {
  record_.reason += (record_.reason.empty() ? "" : "; ") + what;
  record_.end = End::failed;
}

// A problem of a user's may throw here as anywhere; what the meter saw is kept.
Evaluation TrialAudit::audit(const std::vector<double>& x, const std::string& what) {
  std::vector<double> given = x;
  Evaluation result;
  try {
    result = evaluator_.audit(given);
    if (result.ok() && !std::isfinite(result.cost)) result.status = Status::invalid_input;
    if (!result.ok()) fail(fmt::format("a fresh evaluation of {} is {}", what, to_string(result.status)));
  } catch (const std::exception& error) {
    fail(fmt::format("a fresh evaluation of {} threw: {}", what, error.what()));
  } catch (...) {
    fail(fmt::format("a fresh evaluation of {} threw an exception that is no std::exception", what));
  }
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  if (!std::ranges::equal(given, x, same)) fail("the problem changes the point that it is given");
  return result;
}

// A figure that is no number is left out.
template <class Get>
std::optional<double> TrialAudit::figure(const std::string& name, Get get) {
  try {
    const std::optional<double> value = get();
    if (!value || std::isfinite(*value)) return value;
    fail(fmt::format("the {} is {}", name, std::isnan(*value) ? "nan" : fmt::format("{}", *value)));
  } catch (const std::exception& error) {
    fail(fmt::format("the {} threw: {}", name, error.what()));
  } catch (...) {
    fail(fmt::format("the {} threw an exception that is no std::exception", name));
  }
  return std::nullopt;
}

// `data_cost`: the data's part of the cost, where there is a prior.
PointSummary TrialAudit::summarize(const Evaluation& evaluation, std::optional<double> data_cost,
                                   const std::string& what) {
  if (!evaluation.ok()) return {};
  const double cost = evaluation.cost;
  const auto quality_of = [&](double part, const std::string& name) {
    return figure(name + " of " + what, [&] { return std::optional(problem_.quality(part)); });
  };
  PointSummary summary{cost, quality_of(cost, "quality"), {}, {}};
  if (data_cost) summary.data_quality = quality_of(*data_cost, "data's quality");
  summary.relative_error =
      figure("relative error of " + what, [&] { return problem_.relative_error(data_cost.value_or(cost)); });
  return summary;
}

void TrialAudit::note_start(std::span<const double> x) {
  if (!meter_.start().ok()) return;
  const Evaluation audited = audit({x.begin(), x.end()}, "the start");
  record_.start = audited.ok() ? summarize(audited, evaluator_.health().data_cost, "the start")
                               : summarize(meter_.start(), std::nullopt, "the start");
  // The trace stays in falling order: where the first improvement was within rounding, it keeps what the race saw.
  std::vector<TracePoint>& trace = record_.trace;
  const bool begins = !trace.empty() && trace.front().evaluation == 0 && record_.start.quality;
  if (begins && (trace.size() == 1 || *record_.start.quality > trace[1].quality))
    trace.front().quality = *record_.start.quality;
}

// A finding by a name that records have anyhow would be taken for it.
void TrialAudit::note_health() {
  record_.health = evaluator_.health();
  for (const Finding& finding : record_.health.findings)
    if (is_reserved_finding(finding.name))
      fail(fmt::format("the problem has a finding called '{}', which is an entry of every record's; it is left out",
                       finding.name));
  std::erase_if(record_.health.findings, [](const Finding& finding) { return is_reserved_finding(finding.name); });
}

void TrialAudit::note_best(const std::optional<KeptPoint>& chosen) {
  if (const std::optional<OutsidePoint>& outside = meter_.outside()) {
    const Space& space = problem_.space();
    fail(fmt::format("a better point, at evaluation {}, lies outside the box: {} = {} is not within [{}, {}]",
                     outside->evaluation, space.name(outside->coordinate), outside->value,
                     space.lower()[outside->coordinate], space.upper()[outside->coordinate]));
  }
  record_.health.refused = meter_.failed_evaluations();
  if (!meter_.has_best()) {
    fail("no point had a finite cost");
    return;
  }
  const KeptPoint best = chosen ? *chosen : meter_.best();
  const std::vector<double>& x = best.x;
  if (!problem_.space().contains(x)) fail("the best point lies outside the box");
  const Evaluation seen{Status::ok, best.cost};
  const Evaluation audited = audit(x, "the best point");
  note_health();
  record_.health.refused = meter_.failed_evaluations();
  record_.health.drift = meter_.drift();
  if (audited.ok()) {
    const double drift = relative_drift(seen.cost, audited.cost);
    record_.health.drift = std::max(record_.health.drift.value_or(0.0), drift);
    if (contradicts(seen.cost, audited.cost))
      fail(fmt::format("the race saw a cost of {:.6g} at the best point, a fresh evaluation says {:.6g}", seen.cost,
                       audited.cost));
  }
  record_.best = BestPoint{best.at.evaluation,
                           audited.ok() ? summarize(audited, record_.health.data_cost, "the best point")
                                        : summarize(seen, std::nullopt, "the best point"),
                           x, static_cast<std::int64_t>(problem_.space().at_bounds(x))};
  record_.seconds.to_best = best.at.seconds;
}

}  // namespace nodal
