// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/compare.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <nodal/provenance.h>

#include "clocked_trial.h"
#include "contamination.h"
#include "core.h"
#include "lane_trials.h"
#include "open_trials.h"
#include "rerun.h"
#include "running_trials.h"
#include "timing_lane.h"
#include "trial_message.h"

namespace nodal {

namespace {

using Clock = RunningTrials::Clock;

// Some tools stop and continue processes all the time to slow them down: their trials must end, too.
constexpr int kMostStops = 3;
// A comparison that lives says so every two seconds; trials without a deadline must not be lost for a day.
constexpr double kMostPatience = 600.0;
constexpr std::chrono::milliseconds kWaitForOthers{100};

class Comparison {
 public:
  Comparison(const Study& study, const Registry& registry, Store& store, const CompareOptions& options,
             const CompareObserver& observer)
      : study_(study),
        registry_(registry),
        store_(store),
        options_(options),
        observer_(observer),
        rerun_(read_rerun(study, options.rerun, options.fresh)),
        lane_(!options.keys) {}

  CompareResult run() {
    store_.begin(study_);
    for (const std::string& warning : store_.warnings()) warn(warning);
    look_for_others();
    open_.emplace(study_, store_, rerun_, options_.keys);
    result_.failed = open_->failed();
    if (observer_.began) observer_.began(open_->total(), open_->done());
    describe_conditions();
    share_work();
    if (options_.isolate) {
      run_children();
      begin_timing();
      run_children();
    } else {
      run_here();
    }
    if (open_->shared()) count_failures_of_all();
    store_.leave();
    if (!store_.other_writer()) open_->leave_last();
    result_.interrupted = interrupted() && open_->done() < open_->total();
    return result_;
  }

 private:
  bool interrupted() const { return options_.interrupted && options_.interrupted->load(); }

  void warn(const std::string& warning) const {
    if (observer_.warned) observer_.warned(warning);
  }

  void describe_conditions() {
    const Value here = provenance();
    const std::size_t jobs = options_.isolate ? static_cast<std::size_t>(std::max(1, options_.jobs)) : 1;
    conditions_.build = build_id(here);
    conditions_.processor = here.at("processor").text();
    conditions_.jobs = static_cast<std::int64_t>(std::min(jobs, std::max<std::size_t>(1, open_->waiting())));
    conditions_.cores = allowed_cores();
  }

  void look_for_others() {
    if (options_.keys) return;
    const std::optional<int> other = store_.other_writer();
    if (!other) return;
    if (!others_seen_)
      warn(
          fmt::format("another comparison (process {}) writes to '{}' now: they share the trials, and times taken "
                      "meanwhile are marked as contaminated",
                      *other, store_.directory().string()));
    others_seen_ = Clock::now();
  }

  // A share's trials are its own.
  void share_work() {
    if (options_.keys) return;
    const double patience = std::min(kMostPatience, seconds_allowed(study_, options_.grace_seconds));
    open_->share(std::chrono::duration<double>(patience));
  }

  // Trials that others ran have failed like those of this process.
  void count_failures_of_all() {
    const Store all = Store::open_existing(store_.directory());
    result_.failed = 0;
    for (const Trial& trial : all_trials(study_))
      if (const TrialRecord* record = all.find(trial_key(study_, trial))) result_.failed += is_failure(record->end);
  }

  // Trials that ran beside others and lack company that ran alone, once more. Whoever runs a share sees too little for
  // that, and nobody is alone while others work here: their times wait for the next comparison.
  void begin_timing() {
    if (options_.keys || options_.time_lane <= 0 || open_->done() < open_->total()) return;
    if (open_->shared() || store_.other_writer()) return;
    open_->add(lane_trials(study_, store_, options_.time_lane));
    if (open_->waiting() == 0) return;
    conditions_.jobs = 1;
    timing_ = true;
    if (observer_.timing) observer_.timing(open_->waiting());
  }

  bool alone() const { return options_.isolate && conditions_.jobs == 1; }

  void keep(EndedTrial ended) {
    look_for_others();
    TrialRecord& record = ended.record;
    record.attempt = open_->entry(ended.ticket).attempt;
    const std::optional<Conditions> sent = record.conditions;
    describe_conditions(record);
    record.conditions->beside_others = others_seen_ && *others_seen_ >= ended.began;
    record.conditions->stopped = ended.stopped;
    if (alone()) note_lane(record);
    if (timing_) compare_with_former(record);
    const Conditions& now = *record.conditions;
    store(record, ended.line, sent && !now.beside_others && !now.stopped && now.pace == sent->pace);
    open_->stored(ended.ticket);
    ++result_.ran;
    result_.failed += is_failure(record.end);
    if (observer_.finished) observer_.finished(record, open_->done(), open_->total());
  }

  // What its process says of itself is in it already.
  void describe_conditions(TrialRecord& record) const {
    const Conditions own = record.conditions.value_or(Conditions());
    Conditions& conditions = record.conditions.emplace(conditions_);
    conditions.core = own.core;
    conditions.preempted = own.preempted;
    conditions.waited = own.waited;
    conditions.cold = own.cold;
    if (alone()) conditions.pace = lane_.pace();
  }

  // The line as it was sent, where nothing has changed since and nobody asks for more.
  void store(TrialRecord& record, const std::string& line, bool as_sent) {
    if (as_sent && store_.in_memory() == InMemory::short_records) return store_.append(record, line);
    if (!line.empty()) {
      TrialRecord whole = parse_record(line, "trial");
      whole.attempt = record.attempt;
      whole.conditions = record.conditions;
      record = std::move(whole);
    }
    store_.append(record);
  }

  void compare_with_former(const TrialRecord& record) {
    const TrialRecord& former = *store_.find(record.key);
    if (const std::string difference = lane_difference(study_, former, record); !difference.empty())
      warn(fmt::format("{}, repeat {}, did something else when it ran alone: {}", record.optimizer, record.repeat,
                       difference));
  }

  // A trial that is followed by a look has the worse of two.
  void note_lane(TrialRecord& record) {
    lane_.ran(record);
    if (!lane_.due()) return;
    look_at_lane();
    record.conditions->pace = std::max(*record.conditions->pace, lane_.pace());
  }

  // A core that has become slow since the last look was so for some of the trials since then: nobody knows for which.
  void look_at_lane() {
    if (!lane_.used()) return;
    const double before = lane_.pace();
    lane_.look();
    if (before <= kLargestPace && lane_.pace() > kLargestPace)
      warn(
          fmt::format("the core has become {:.2f} times as slow as at its fastest: what runs now is marked as "
                      "contaminated, what ran in the seconds before may have been disturbed, too",
                      lane_.pace()));
  }

  // What JSON can't hold (a relative error that is NaN, say) and an exception that is no std::exception are rows with
  // their reason, too.
  std::string run_to_message(const Trial& trial, std::size_t ticket) const {
    std::string reason;
    try {
      TrialRecord record = run_clocked_trial(study_, trial, registry_, alone() ? lane_.core() : std::nullopt);
      record.attempt = open_->entry(ticket).attempt;
      describe_conditions(record);
      return trial_message(record);
    } catch (const std::exception& error) {
      reason = error.what();
    } catch (...) {
      reason = "an exception that is no std::exception";
    }
    return trial_message(lost_trial(study_, trial, End::failed, "no record could be made: " + reason));
  }

  void run_here() {
    while (!interrupted() && open_->waiting() > 0) {
      open_->beat();
      const std::optional<std::size_t> ticket = open_->next();
      if (!ticket) {
        wait_for_others();
        continue;
      }
      const Clock::time_point began = Clock::now();
      auto [record, line] = read_trial_message(run_to_message(open_->entry(*ticket).trial, *ticket));
      keep({*ticket, std::move(record), std::move(line), false, began});
    }
  }

  void run_children() {
    RunningTrials running(
        study_, [this](const Trial& trial, std::size_t ticket) { return run_to_message(trial, ticket); },
        options_.grace_seconds);
    if (alone() && open_->waiting() > 0) lane_.look();
    while (!interrupted() && (open_->waiting() > 0 || running.size() > 0)) {
      start_trials(running);
      for (EndedTrial& ended : running.wait()) {
        // Whoever interrupts this process may have ended its children, too: they have not crashed.
        if (interrupted() && ended.record.end == End::crashed) continue;
        if (run_again(ended))
          open_->again(ended.ticket);
        else
          keep(std::move(ended));
      }
      look_for_others();
    }
    if (alone()) look_at_lane();
    // What an interrupt left running is killed here: it is not stored and runs again next time.
  }

  // As many as may run at once.
  void start_trials(RunningTrials& running) {
    const auto jobs = static_cast<std::size_t>(conditions_.jobs);
    while (running.size() < jobs) {
      const std::optional<std::size_t> ticket = open_->next();
      if (!ticket) break;
      running.start(open_->entry(*ticket).trial, *ticket);
    }
    open_->beat();
    if (running.size() == 0) wait_for_others();
  }

  void wait_for_others() const {
    if (open_->waiting() > 0) std::this_thread::sleep_for(kWaitForOthers);
  }

  bool run_again(const EndedTrial& ended) {
    if (!ended.stopped || open_->count_stop(ended.ticket) > kMostStops) return false;
    warn(fmt::format("{}, repeat {}, was stopped and continued while it ran: it runs again", ended.record.optimizer,
                     ended.record.repeat));
    return true;
  }

  const Study& study_;
  const Registry& registry_;
  Store& store_;
  const CompareOptions& options_;
  const CompareObserver& observer_;
  Rerun rerun_;
  Conditions conditions_;
  TimingLane lane_;
  bool timing_ = false;             // trials that are stored run once more
  std::optional<OpenTrials> open_;  // once the store is as others have left it
  std::optional<Clock::time_point> others_seen_;
  CompareResult result_;
};

}  // namespace

void require_comparable(const Study& study, const CompareOptions& options) {
  const Source file{study.path.string(), 0};
  if (study.optimizers.empty())
    throw InputError(file,
                     "the study has no optimizer to compare; add an [[optimizer]] table, e.g. use = \"annealing\"");
  if (!study.budget.seconds && !study.budget.evaluations)
    throw InputError(file, "the study sets no budget; give [budget] seconds or evaluations");
  for (const StudyProblem& entry : study.problems)
    if (const std::string refusal = entry.problem->fit_refusal(); !refusal.empty()) throw InputError(refusal);
  (void)read_rerun(study, options.rerun, options.fresh);
}

CompareResult compare(const Study& study, const Registry& registry, Store& store, const CompareOptions& options,
                      const CompareObserver& observer) {
  require_comparable(study, options);
  return Comparison(study, registry, store, options, observer).run();
}

}  // namespace nodal
