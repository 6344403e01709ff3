// SPDX-License-Identifier: GPL-3.0-or-later
#include "running_trials.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "trial_message.h"

namespace nodal {

namespace {

// A method may look at the clock as seldom as its library lets it; one this late hangs.
constexpr double kDeadlineFactor = 10.0;
// Nobody said how long a trial may take.
constexpr double kDeadlineWithoutSeconds = 24.0 * 3600.0;
// How long an interrupt may go unseen while children run, and a child that says nothing unwatched.
constexpr double kLookSeconds = 0.1;
// A look that comes later than this was not late by being busy: this process was stopped.
constexpr double kMissedSeconds = 0.5;
// Of the time that this process missed its child did nothing either, if it had no processor for at least this share.
constexpr double kIdleShare = 0.5;
// Who kills a child may be about to kill this process, too; then the child has not crashed.
constexpr std::chrono::milliseconds kBeforeACrashIsBelieved{100};

}  // namespace

double seconds_allowed(const Study& study, double grace_seconds) {
  if (!study.budget.seconds) return kDeadlineWithoutSeconds;
  return kDeadlineFactor * *study.budget.seconds + grace_seconds;
}

void RunningTrials::start(const Trial& trial, std::size_t ticket) {
  if (running_.empty()) last_look_ = Clock::now();
  auto child = std::make_unique<ChildProcess>([this, &trial, ticket] {
    for (const Running& other : running_) ::close(other.child->descriptor());  // not this child's business
    return work_(trial, ticket);
  });
  running_.push_back(
      {trial, ticket, std::move(child), Clock::now(), seen_ + seconds_allowed(study_, grace_seconds_), 0.0});
}

std::vector<EndedTrial> RunningTrials::wait() {
  poll_children();
  note_passed_time();
  std::vector<EndedTrial> ended;
  for (std::size_t i = running_.size(); i-- > 0;) {
    const bool by_itself = running_[i].child->ended();
    if (!by_itself && seen_ <= running_[i].deadline) continue;
    const Running entry = std::move(running_[i]);
    running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
    ended.push_back(by_itself ? collect(entry) : hung(entry));
  }
  return ended;
}

void RunningTrials::poll_children() const {
  std::vector<pollfd> descriptors;
  for (const Running& entry : running_) descriptors.push_back({entry.child->descriptor(), POLLIN, 0});
  ::poll(descriptors.data(), descriptors.size(), static_cast<int>(1000.0 * kLookSeconds));
}

void RunningTrials::note_passed_time() {
  const Clock::time_point now = Clock::now();
  const double passed = std::chrono::duration<double>(now - last_look_).count();
  last_look_ = now;
  seen_ += std::min(passed, kMissedSeconds);
  if (passed <= kMissedSeconds) return;
  for (Running& entry : running_) entry.missed += passed - kLookSeconds;
}

EndedTrial RunningTrials::collect(const Running& entry) const {
  const ChildProcess& child = *entry.child;
  const auto crashed = [&](const std::string& how) {
    if (child.died_of_signal()) std::this_thread::sleep_for(kBeforeACrashIsBelieved);
    return EndedTrial{entry.ticket, lost_trial(study_, entry.trial, End::crashed, how), {}, false, entry.began};
  };
  if (!child.whole() && !child.death().empty()) return crashed("the trial's process died: " + child.death());
  if (child.output().empty()) return crashed("the trial's process ended without a record");
  try {
    auto [record, line] = read_trial_message(child.output());
    const double idle = record.seconds.total - record.seconds.cpu;
    const bool missed = entry.missed > 0.0 && idle >= kIdleShare * entry.missed;
    return {entry.ticket, std::move(record), std::move(line), missed || child.was_stopped(), entry.began};
  } catch (const InputError& error) {
    return crashed(fmt::format("the trial's process sent no record: {}", error.what()));
  }
}

EndedTrial RunningTrials::hung(const Running& entry) const {
  const double allowed = seconds_allowed(study_, grace_seconds_);
  const std::string why = entry.child->is_stopped()
                              ? fmt::format("killed after {:g} s: its process was stopped by a signal", allowed)
                              : fmt::format("killed after {:g} s: it did not stop by itself", allowed);
  TrialRecord record = lost_trial(study_, entry.trial, End::timeout, why);
  record.seconds.total = std::chrono::duration<double>(Clock::now() - entry.began).count() - entry.missed;
  return {entry.ticket, std::move(record), {}, false, entry.began};
}

}  // namespace nodal
