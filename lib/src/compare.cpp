// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/compare.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <thread>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <nodal/provenance.h>

#include "clocked_trial.h"
#include "contamination.h"
#include "core.h"
#include "lane_trials.h"
#include "rerun.h"
#include "running_trials.h"
#include "timing_lane.h"
#include "trial_claims.h"
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
    find_missing();
    describe_conditions();
    share_work();
    if (options_.isolate) {
      run_children();
      begin_timing();
      run_children();
    } else {
      run_here();
    }
    if (shared_) count_failures_of_all();
    store_.leave();
    if (claims_ && !store_.other_writer()) claims_->leave_last();
    result_.interrupted = interrupted() && done_ < total_;
    return result_;
  }

 private:
  struct Missing {
    Trial trial;
    std::int64_t attempt = 1;
    int stops = 0;
  };

  bool interrupted() const { return options_.interrupted && options_.interrupted->load(); }

  void warn(const std::string& warning) const {
    if (observer_.warned) observer_.warned(warning);
  }

  void find_missing() {
    std::optional<std::unordered_set<std::string>> own;
    if (options_.keys) own.emplace(options_.keys->begin(), options_.keys->end());
    for (const Trial& trial : all_trials(study_)) {
      const std::string key = trial_key(study_, trial);
      if (own && !own->contains(key)) continue;
      ++total_;
      const TrialRecord* stored = store_.find(key);
      if (stored && !rerun_.means(*stored)) {
        result_.failed += is_failure(stored->end);
        ++done_;
      } else {
        missing_.push_back({trial, stored ? stored->attempt + 1 : 1});
      }
    }
    if (observer_.began) observer_.began(total_, done_);
  }

  void describe_conditions() {
    const Value here = provenance();
    const std::size_t jobs = options_.isolate ? static_cast<std::size_t>(std::max(1, options_.jobs)) : 1;
    conditions_.build = build_id(here);
    conditions_.processor = here.at("processor").text();
    conditions_.jobs = static_cast<std::int64_t>(std::min(jobs, std::max<std::size_t>(1, missing_.size())));
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
    if (options_.keys || missing_.empty()) return;
    const double patience = std::min(kMostPatience, seconds_allowed(study_, options_.grace_seconds));
    claims_.emplace(store_.directory(), !store_.other_writer(), std::chrono::duration<double>(patience));
  }

  // What somebody else has stored meanwhile counts as done.
  TrialClaims::Answer claim(const Missing& entry) {
    if (!claims_) return TrialClaims::Answer::granted;
    const TrialClaims::Answer answer = claims_->claim(trial_key(study_, entry.trial), entry.attempt);
    if (answer == TrialClaims::Answer::done) {
      ++done_;
      shared_ = true;
    }
    return answer;
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
    missing_.clear();
    if (options_.keys || options_.time_lane <= 0 || done_ < total_) return;
    if (shared_ || store_.other_writer()) return;
    for (const Trial& trial : lane_trials(study_, store_, options_.time_lane))
      missing_.push_back({trial, store_.find(trial_key(study_, trial))->attempt + 1});
    if (missing_.empty()) return;
    conditions_.jobs = 1;
    total_ += missing_.size();
    timing_ = true;
    if (observer_.timing) observer_.timing(missing_.size());
  }

  bool alone() const { return options_.isolate && conditions_.jobs == 1; }

  void keep(EndedTrial ended) {
    look_for_others();
    TrialRecord& record = ended.record;
    record.attempt = missing_[ended.ticket].attempt;
    const std::optional<Conditions> sent = record.conditions;
    describe_conditions(record);
    record.conditions->beside_others = others_seen_ && *others_seen_ >= ended.began;
    record.conditions->stopped = ended.stopped;
    if (alone()) note_lane(record);
    if (timing_) compare_with_former(record);
    const Conditions& now = *record.conditions;
    store(record, ended.line, sent && !now.beside_others && !now.stopped && now.pace == sent->pace);
    if (claims_) claims_->done(record.key, record.attempt);
    ++result_.ran;
    ++done_;
    result_.failed += is_failure(record.end);
    if (observer_.finished) observer_.finished(record, done_, total_);
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
      record.attempt = missing_[ticket].attempt;
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
    for (std::size_t i = 0; i < missing_.size() && !interrupted(); ++i) {
      if (claim(missing_[i]) != TrialClaims::Answer::granted) continue;
      const Clock::time_point began = Clock::now();
      auto [record, line] = read_trial_message(run_to_message(missing_[i].trial, i));
      keep({i, std::move(record), std::move(line), false, began});
    }
  }

  void run_children() {
    std::deque<std::size_t> next;  // indices of `missing_`
    for (std::size_t i = 0; i < missing_.size(); ++i) next.push_back(i);
    RunningTrials running(
        study_, [this](const Trial& trial, std::size_t ticket) { return run_to_message(trial, ticket); },
        options_.grace_seconds);
    if (alone() && !next.empty()) lane_.look();
    while (!interrupted() && (!next.empty() || running.size() > 0)) {
      start_trials(next, running);
      for (EndedTrial& ended : running.wait()) {
        // Whoever interrupts this process may have ended its children, too: they have not crashed.
        if (interrupted() && ended.record.end == End::crashed) continue;
        if (run_again(ended))
          next.push_front(ended.ticket);
        else
          keep(std::move(ended));
      }
      look_for_others();
    }
    if (alone()) look_at_lane();
    // What an interrupt left running is killed here: it is not stored and runs again next time.
  }

  // As many as may run at once. Those that another comparison runs stay in the list until it has stored them, or has
  // died.
  void start_trials(std::deque<std::size_t>& next, RunningTrials& running) {
    const auto jobs = static_cast<std::size_t>(conditions_.jobs);
    for (std::size_t looks = next.size(); looks > 0 && running.size() < jobs; --looks) {
      const std::size_t ticket = next.front();
      next.pop_front();
      const TrialClaims::Answer answer = claim(missing_[ticket]);
      if (answer == TrialClaims::Answer::granted) running.start(missing_[ticket].trial, ticket);
      if (answer == TrialClaims::Answer::others) next.push_back(ticket);
    }
    if (claims_) claims_->beat();
    if (running.size() == 0 && !next.empty()) std::this_thread::sleep_for(kWaitForOthers);
  }

  bool run_again(const EndedTrial& ended) {
    if (!ended.stopped || ++missing_[ended.ticket].stops > kMostStops) return false;
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
  bool timing_ = false;  // trials that are stored run once more
  std::vector<Missing> missing_;
  std::optional<TrialClaims> claims_;  // where work is shared
  bool shared_ = false;                // others have run some of it
  std::optional<Clock::time_point> others_seen_;
  std::size_t total_ = 0, done_ = 0;
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
