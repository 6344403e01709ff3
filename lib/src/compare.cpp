// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/compare.h>

#include <poll.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "child_process.h"

namespace nodal {

namespace {

using Clock = ChildProcess::Clock;

// A method may look at the clock as seldom as its library lets it; one this late hangs.
constexpr double kDeadlineFactor = 10.0;
// Nobody said how long a trial may take.
constexpr double kDeadlineWithoutSeconds = 24.0 * 3600.0;
// As long as the clock's nanoseconds can count with room to spare: 31 years.
constexpr double kLatestDeadlineSeconds = 1e9;
// How long an interrupt may go unseen while children run.
constexpr double kLookSeconds = 0.1;

double seconds_allowed(const Study& study, double grace_seconds) {
  if (!study.budget.seconds) return kDeadlineWithoutSeconds;
  return std::min(kDeadlineFactor * *study.budget.seconds + grace_seconds, kLatestDeadlineSeconds);
}

struct Running {
  Trial trial;
  std::unique_ptr<ChildProcess> child;
};

class Comparison {
 public:
  Comparison(const Study& study, const Registry& registry, Store& store, const CompareOptions& options,
             const CompareObserver& observer)
      : study_(study), registry_(registry), store_(store), options_(options), observer_(observer) {}

  CompareResult run() {
    store_.begin(study_);
    find_missing();
    if (options_.isolate)
      run_children();
    else
      run_here();
    result_.interrupted = interrupted() && done_ < total_;
    return result_;
  }

 private:
  bool interrupted() const { return options_.interrupted && options_.interrupted->load(); }

  void find_missing() {
    const std::vector<Trial> all = all_trials(study_);
    total_ = all.size();
    for (const Trial& trial : all) {
      if (const TrialRecord* stored = store_.find(trial_key(study_, trial))) {
        result_.failed += is_failure(stored->end);
        ++done_;
      } else {
        missing_.push_back(trial);
      }
    }
    if (observer_.began) observer_.began(total_, done_);
  }

  void keep(const TrialRecord& record) {
    store_.append(record);
    ++result_.ran;
    ++done_;
    result_.failed += is_failure(record.end);
    if (observer_.finished) observer_.finished(record, done_, total_);
  }

  // A forked process meets the program's pages one by one, which can take longer than a hundred small evaluations. One
  // value of an evaluator that is thrown away takes that out of the trial's times, for every method alike.
  void warm_up(const Trial& trial) const {
    const Problem& problem = *study_.problems.at(trial.problem).problem;
    try {
      (void)problem.make_evaluator()->value(problem.space().start());
    } catch (...) {  // the trial will say what is wrong
    }
  }

  // The record as it is stored. What JSON can't hold (a relative error that is NaN, say) and an exception that is no
  // std::exception are rows with their reason, too.
  std::string run_to_line(const Trial& trial) const {
    std::string reason;
    warm_up(trial);
    try {
      return to_json_line(run_trial(study_, trial, registry_));
    } catch (const std::exception& error) {
      reason = error.what();
    } catch (...) {
      reason = "an exception that is no std::exception";
    }
    return to_json_line(lost_trial(study_, trial, End::failed, "no record could be made: " + reason));
  }

  void run_here() {
    for (const Trial& trial : missing_) {
      if (interrupted()) return;
      keep(parse_record(run_to_line(trial), "trial"));
    }
  }

  void run_children() {
    std::size_t next = 0;
    while (!interrupted() && (next < missing_.size() || !running_.empty())) {
      while (next < missing_.size() && running_.size() < static_cast<std::size_t>(std::max(1, options_.jobs)))
        start(missing_[next++]);
      wait();
    }
    running_.clear();  // kills what an interrupt left running: it is not stored and runs again next time
  }

  void start(const Trial& trial) {
    const std::chrono::duration<double> allowed(seconds_allowed(study_, options_.grace_seconds));
    const Clock::time_point deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(allowed);
    running_.push_back({trial, std::make_unique<ChildProcess>([this, trial] { return run_to_line(trial); }, deadline)});
  }

  // Until a child says something, reaches its deadline, or it is time to look for an interrupt.
  void wait() {
    std::vector<pollfd> descriptors;
    for (const Running& entry : running_) descriptors.push_back({entry.child->descriptor(), POLLIN, 0});
    ::poll(descriptors.data(), descriptors.size(), static_cast<int>(1000.0 * kLookSeconds));
    for (std::size_t i = running_.size(); i-- > 0;) {
      ChildProcess& child = *running_[i].child;
      const bool ended = descriptors[i].revents != 0 && child.read_more();
      const bool late = !ended && Clock::now() > child.deadline();
      if (!ended && !late) continue;
      const Running entry = std::move(running_[i]);
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
      keep(late ? hung(entry) : collect(entry));
    }
  }

  TrialRecord hung(const Running& entry) const {
    entry.child->kill();
    (void)entry.child->finish();
    return lost_trial(
        study_, entry.trial, End::timeout,
        fmt::format("killed after {:g} s: it did not stop by itself", seconds_allowed(study_, options_.grace_seconds)));
  }

  TrialRecord collect(const Running& entry) const {
    if (const std::optional<std::string> death = entry.child->finish())
      return lost_trial(study_, entry.trial, End::crashed, "the trial's process died: " + *death);
    if (entry.child->output().empty())
      return lost_trial(study_, entry.trial, End::crashed, "the trial's process ended without a record");
    try {
      return parse_record(entry.child->output(), "trial");
    } catch (const InputError& error) {
      return lost_trial(study_, entry.trial, End::crashed,
                        fmt::format("the trial's process sent no record: {}", error.what()));
    }
  }

  const Study& study_;
  const Registry& registry_;
  Store& store_;
  const CompareOptions& options_;
  const CompareObserver& observer_;
  std::vector<Trial> missing_;
  std::vector<Running> running_;
  std::size_t total_ = 0, done_ = 0;
  CompareResult result_;
};

}  // namespace

void require_comparable(const Study& study) {
  const Source file{study.path.string(), 0};
  if (study.optimizers.empty())
    throw InputError(file,
                     "the study has no optimizer to compare; add an [[optimizer]] table, e.g. use = \"annealing\"");
  if (!study.budget.seconds && !study.budget.evaluations)
    throw InputError(file, "the study sets no budget; give [budget] seconds or evaluations");
}

CompareResult compare(const Study& study, const Registry& registry, Store& store, const CompareOptions& options,
                      const CompareObserver& observer) {
  require_comparable(study);
  return Comparison(study, registry, store, options, observer).run();
}

}  // namespace nodal
