// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/trial.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include <nodal/alternating.h>
#include <nodal/show/number_text.h>
#include <nodal/shown.h>

#include "independent_look.h"
#include "known_quality.h"
#include "trial_audit.h"
#include "trial_search.h"
#include "trial_unseen.h"

namespace nodal {

namespace {

// A deterministic method from one start ends in the same place every time: these repeats are for its run time.
constexpr int kDeterministicRepeats = 3;
constexpr int kKeyedDigits = 10;

TrialRecord blank_record(const Study& study, const Trial& trial) {
  const StudyOptimizer& optimizer = study.optimizers.at(trial.optimizer);
  TrialRecord record;
  record.key = trial_key(study, trial);
  record.problem = study.problems.at(trial.problem).label;
  record.optimizer = optimizer.label;
  record.use = optimizer.use;
  record.repeat = trial.repeat;
  record.seed = trial_seed(study, trial);
  record.options = optimizer.options.values();
  return record;
}

// One trial while it runs: the objects that are made afresh for it, and what becomes of them.
class Run {
 public:
  Run(const Study& study, const Trial& trial, const Registry& registry, TrialRecord& record)
      : study_(study),
        trial_(trial),
        registry_(registry),
        record_(record),
        problem_(*study.problems.at(trial.problem).problem) {}

  void execute() {
    if (const std::string refusal = problem_.fit_refusal(); !refusal.empty()) throw InputError(refusal);
    race();
    // The race's evaluator is gone: there is never room for two of a large problem's.
    if (record_.best && seen_) note(look_independently(problem_, record_.best->x, *seen_));
  }

 private:
  void race() {
    const double cpu_began = processor_seconds();
    const Meter::Clock::time_point began = Meter::Clock::now();
    const auto since = [began] { return std::chrono::duration<double>(Meter::Clock::now() - began).count(); };

    const std::unique_ptr<Evaluator> evaluator = problem_.make_evaluator();
    const std::vector<double> start = trial_start(study_, trial_);
    Meter meter(problem_, *evaluator, start, trial_limits(study_), began);
    record_.flops_per_value = evaluator->work().flops;

    const double search_began = since();
    const Outcome outcome = search(study_, trial_, registry_, meter, start);
    const double search_ended = since();

    record_.work = evaluator->work();
    note_end(meter, outcome);
    TrialUnseen unseen(problem_, *evaluator, meter, record_);
    std::optional<KeptPoint> chosen;
    double unseen_seconds = 0.0, unseen_cpu = 0.0;
    if (study_.budget.validated) {
      unseen_seconds = -since(), unseen_cpu = -processor_seconds();
      unseen.measure();
      chosen = unseen.choose();
      unseen_seconds += since(), unseen_cpu += processor_seconds();
    }
    TrialAudit audit(problem_, *evaluator, meter, record_);
    audit.note_start(start);
    audit.note_best(chosen);
    if (meter.has_best()) seen_ = chosen ? chosen->cost : meter.best_cost();
    note_claim(meter, outcome);
    const double search_seconds = search_ended - search_began;
    record_.seconds.total = since() - unseen_seconds;
    record_.seconds.evaluation = std::min(meter.evaluation_seconds(), search_seconds);
    record_.seconds.optimizer = search_seconds - record_.seconds.evaluation;
    record_.seconds.harness = record_.seconds.total - search_seconds;
    record_.seconds.cpu = std::max(0.0, processor_seconds() - cpu_began - unseen_cpu);
    // What chooses nothing waits until the clock has stopped.
    if (!study_.budget.validated) unseen.measure();
    unseen.note_finding();
  }

  void note(const IndependentLook& look) {
    record_.audit = look.record;
    if (look.refuted.empty() || record_.end == End::failed) return;
    record_.end = End::failed;
    record_.reason += (record_.reason.empty() ? "" : "; ") + look.refuted;
  }

  void note_end(const Meter& meter, const Outcome& outcome) {
    switch (meter.stop()) {
      case Stop::none:
        record_.end = End::finished;
        break;
      case Stop::target:
        record_.end = End::target;
        break;
      case Stop::evaluations:
      case Stop::seconds:
        record_.end = End::budget;
        break;
    }
    record_.reason = meter.stop() == Stop::none          ? outcome.reason
                     : meter.stop() == Stop::target      ? "target reached"
                     : meter.stop() == Stop::evaluations ? kEvaluationsSpent
                                                         : "seconds spent";
    record_.limited = outcome.limited && record_.end == End::finished && !outcome.failed;
    if (outcome.failed) {
      record_.end = End::failed;
      record_.reason = outcome.reason;
    }
    for (const auto& [key, value] : outcome.effective_options.table())
      record_.options.set(key, value.is_number() && !std::isfinite(value.number()) ? Value("no number") : value);
    record_.counts = meter.counts();
    record_.moves = meter.moves_report();
    record_.trace = meter.trace();
    std::erase_if(record_.trace, [](const TracePoint& p) { return !std::isfinite(p.quality); });
    thin_trace(record_.trace, 2000);
  }

  void note_claim(const Meter& meter, const Outcome& outcome) {
    if (!outcome.claim) return;
    const Claim& claim = *outcome.claim;
    ClaimRecord stored;
    if (claim.cost && std::isfinite(*claim.cost)) stored.cost = claim.cost;
    if (!claim.x.empty() && meter.has_best()) stored.x_equals_best = std::ranges::equal(claim.x, meter.best_point());
    stored.evaluations = claim.evaluations;
    stored.status = claim.status;
    record_.claimed = stored;
  }

  const Study& study_;
  const Trial& trial_;
  const Registry& registry_;
  TrialRecord& record_;
  const Problem& problem_;
  std::optional<double> seen_;  // by the race: the cost of the point that is reported
};

}  // namespace

std::vector<Trial> all_trials(const Study& study) {
  std::vector<Trial> trials;
  for (std::size_t problem = 0; problem < study.problems.size(); ++problem) {
    if (study.problems[problem].skipped) continue;
    for (int repeat = 0; repeat < study.repeats; ++repeat) {
      for (std::size_t optimizer = 0; optimizer < study.optimizers.size(); ++optimizer) {
        if (study.optimizers[optimizer].skipped) continue;
        const bool same_every_time = study.optimizers[optimizer].deterministic && study.starts == Starts::initial;
        if (!same_every_time || repeat < kDeterministicRepeats) trials.push_back({problem, optimizer, repeat});
      }
    }
  }
  return trials;
}

std::vector<double> trial_start(const Study& study, const Trial& trial) {
  const StudyProblem& entry = study.problems.at(trial.problem);
  const Space& space = entry.problem->space();
  std::vector<double> start(space.start().begin(), space.start().end());
  if (study.starts == Starts::sampled && trial.repeat > 0) {
    RandomStream random(stream_key(study, entry.label, "start", trial.repeat));
    for (std::size_t i = 0; i < start.size(); ++i) start[i] = random.uniform(space.lower()[i], space.upper()[i]);
  }
  return start;
}

std::string trial_key(const Study& study, const Trial& trial) {
  const StudyProblem& problem = study.problems.at(trial.problem);
  const StudyOptimizer& optimizer = study.optimizers.at(trial.optimizer);
  Value::List start;
  for (const double x : trial_start(study, trial)) start.emplace_back(x);
  Value budget;
  if (study.budget.seconds) budget.set("seconds", *study.budget.seconds);
  if (study.budget.evaluations) budget.set("evaluations", *study.budget.evaluations);
  if (study.budget.target_gap && problem.best_known) {
    budget.set("target_gap", *study.budget.target_gap);
    // Of an evaluated one builds may have other last digits.
    const KnownOptimum& known = *problem.best_known;
    budget.set("best_known", known.x.empty() ? known.quality : rounded(known.quality, kKeyedDigits));
  }
  if (study.budget.validated) budget.set("stop", "unseen");
  Value content;
  content.set("schema", kRecordSchema);
  content.set("kind", problem.kind);
  content.set("problem", problem.options.values());
  if (!problem.fingerprint.empty()) content.set("inputs", problem.fingerprint);
  content.set("use", optimizer.use);
  content.set("multi_start", optimizer.multi_start);
  content.set("options", optimizer.options.values());
  content.set("budget", budget);
  content.set("seed", Value(trial_seed(study, trial)));
  content.set("start", Value(start));
  content.set("repeat", trial.repeat);
  return hash128(to_canonical_json(content));
}

double target_quality(const Study& study, const Trial& trial, double start_quality) {
  const auto& best_known = study.problems.at(trial.problem).best_known;
  if (!study.budget.target_gap || !best_known) return -std::numeric_limits<double>::infinity();
  const double target = best_known->quality + *study.budget.target_gap * (start_quality - best_known->quality);
  const bool there = start_quality <= best_known->quality + known_to(best_known->quality);
  return there ? std::max(target, start_quality) : target;
}

TrialRecord run_trial(const Study& study, const Trial& trial, const Registry& registry) {
  TrialRecord record = blank_record(study, trial);
  try {
    Run(study, trial, registry, record).execute();
  } catch (const std::exception& error) {  // of the problem itself, before or after the search
    record.end = End::failed;
    record.reason = error.what();
  } catch (...) {
    record.end = End::failed;
    record.reason = "an exception that is no std::exception";
  }
  record.reason = beginning(record.reason, kMostOfAReason);
  if (record.claimed) record.claimed->status = beginning(record.claimed->status, kMostOfAReason);
  return record;
}

TrialRecord lost_trial(const Study& study, const Trial& trial, End end, const std::string& reason) {
  TrialRecord record = blank_record(study, trial);
  record.end = end;
  record.reason = beginning(reason, kMostOfAReason);
  return record;
}

}  // namespace nodal
