// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_trials.h"

#include <unordered_set>

namespace nodal {

OpenTrials::OpenTrials(const Study& study, const Store& store, const Rerun& rerun,
                       const std::optional<std::vector<std::string>>& keys)
    : study_(study), store_(store) {
  std::optional<std::unordered_set<std::string>> own;
  if (keys) own.emplace(keys->begin(), keys->end());
  for (const Trial& trial : all_trials(study)) {
    const std::string key = trial_key(study, trial);
    if (own && !own->contains(key)) continue;
    ++total_;
    const TrialRecord* record = store.find(key);
    if (record && !rerun.means(*record)) {
      failed_ += is_failure(record->end);
      ++done_;
    } else {
      waiting_.push_back(entries_.size());
      entries_.push_back({trial, record ? record->attempt + 1 : 1});
    }
  }
}

void OpenTrials::share(std::chrono::duration<double> patience) {
  if (!entries_.empty()) claims_.emplace(store_.directory(), patience);
}

std::optional<std::size_t> OpenTrials::next() {
  for (std::size_t looks = waiting_.size(); looks > 0; --looks) {
    const std::size_t ticket = waiting_.front();
    waiting_.pop_front();
    switch (claim(entries_[ticket])) {
      case TrialClaims::Answer::granted:
        return ticket;
      case TrialClaims::Answer::others:
        waiting_.push_back(ticket);
        break;
      case TrialClaims::Answer::done:
        ++done_;
        shared_ = true;
        break;
    }
  }
  return std::nullopt;
}

TrialClaims::Answer OpenTrials::claim(const Entry& entry) {
  return claims_ ? claims_->claim(trial_key(study_, entry.trial), entry.attempt) : TrialClaims::Answer::granted;
}

void OpenTrials::stored(std::size_t ticket) {
  const Entry& entry = entries_[ticket];
  if (claims_) claims_->done(trial_key(study_, entry.trial), entry.attempt);
  ++done_;
}

void OpenTrials::beat() {
  if (claims_) claims_->beat();
}

void OpenTrials::leave_last() {
  if (claims_) claims_->leave_last();
}

void OpenTrials::add(const std::vector<Trial>& trials) {
  for (const Trial& trial : trials) {
    waiting_.push_back(entries_.size());
    entries_.push_back({trial, store_.find(trial_key(study_, trial))->attempt + 1});
  }
  total_ += trials.size();
}

}  // namespace nodal
