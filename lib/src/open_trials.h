// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The trials that a comparison has to run: handed out one by one, each claimed first where others write to the same
/// store (trial_claims.h).
///
/// Cost     a hash per trial of the study when it is made; where others share, some file operations per trial.
/// Threads  one object, one thread.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include <nodal/store.h>
#include <nodal/trial.h>

#include "rerun.h"
#include "trial_claims.h"

namespace nodal {

class OpenTrials {
 public:
  struct Entry {
    Trial trial;
    std::int64_t attempt = 1;
    int stops = 0;  ///< while it ran
  };

  /// Those of the study, or of `keys`, that the store lacks or that run again.
  OpenTrials(const Study& study, const Store& store, const Rerun& rerun,
             const std::optional<std::vector<std::string>>& keys);

  [[nodiscard]] std::size_t total() const noexcept { return total_; }
  [[nodiscard]] std::size_t done() const noexcept { return done_; }
  /// Of those that were stored before.
  [[nodiscard]] std::size_t failed() const noexcept { return failed_; }
  /// Not handed out yet, those included that others run now.
  [[nodiscard]] std::size_t waiting() const noexcept { return waiting_.size(); }
  /// Others have stored some of them.
  [[nodiscard]] bool shared() const noexcept { return shared_; }
  [[nodiscard]] const Entry& entry(std::size_t ticket) const { return entries_[ticket]; }

  /// From now on others are looked out for. An owner of claims may be silent for `patience`.
  void share(std::chrono::duration<double> patience);
  /// A ticket for one that nobody else runs; empty when others run all that wait. Those stay until they are stored, or
  /// whoever runs them has died.
  [[nodiscard]] std::optional<std::size_t> next();
  /// One more stop of its process, and how many that makes.
  int count_stop(std::size_t ticket) { return ++entries_[ticket].stops; }
  /// Hands it out once more, before all others.
  void again(std::size_t ticket) { waiting_.push_front(ticket); }
  /// After its record was stored.
  void stored(std::size_t ticket);
  /// At least every two seconds while trials run: this comparison lives.
  void beat();
  /// Nobody else is known to write to the store: claims are cleared in the end.
  void leave_last();
  /// Stored trials run once more.
  void add(const std::vector<Trial>& trials);

 private:
  TrialClaims::Answer claim(const Entry& entry);

  const Study& study_;
  const Store& store_;
  std::vector<Entry> entries_;       // by ticket
  std::deque<std::size_t> waiting_;  // tickets
  std::optional<TrialClaims> claims_;
  std::size_t total_ = 0, done_ = 0, failed_ = 0;
  bool shared_ = false;
};

}  // namespace nodal
