// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How comparisons that write to one store share its trials: whoever makes the file of a trial's claim first runs it.
///
/// claims/KEY.ATTEMPT holds the name of its owner, and "done" once the trial is stored. claims/OWNER.alive is touched
/// every two seconds by a comparison that lives. A claim is stale, and whoever sees that first takes it over, when its
/// owner has left no such file, has not touched it for longer than its trials may take, or is a process of this machine
/// that is no more. Ages are differences between times of one file system's files: clocks of machines may differ.
/// Nothing is lost if it all goes wrong: a trial that two run is stored twice, and the first counts.
///
/// Whoever comes to a folder in which nobody lives, and whoever leaves one last, clears it of claims.
///
/// Errors   a file system that lets no claims be made shares no work: every claim is granted.
/// Threads  one object, one thread.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

namespace nodal {

class TrialClaims {
 public:
  enum class Answer {
    granted,
    others,  ///< somebody who lives runs it
    done,    ///< somebody has stored it since this store was read
  };

  /// `patience`: how long an owner may be silent.
  TrialClaims(const std::filesystem::path& store, std::chrono::duration<double> patience);
  /// Gives back what was claimed and is not done.
  ~TrialClaims();
  TrialClaims(const TrialClaims&) = delete;
  TrialClaims& operator=(const TrialClaims&) = delete;

  [[nodiscard]] Answer claim(const std::string& key, std::int64_t attempt);
  /// After the trial's record was stored.
  void done(const std::string& key, std::int64_t attempt);
  /// Call it at least every two seconds.
  void beat();
  /// Clears the folder at the end if nobody else lives in it: for who knows of nobody who is about to come.
  void leave_last() { last_ = true; }

 private:
  bool make(const std::string& name);
  std::filesystem::path alive(const std::string& owner) const;
  void make_alive();
  bool lives(const std::string& owner) const;
  bool others_live() const;
  void clear() const;
  bool take_over(const std::string& name, const std::string& owner);

  std::filesystem::path folder_;
  std::string own_;  ///< this comparison's name; empty where no claim can be made
  std::chrono::duration<double> patience_;
  std::chrono::steady_clock::time_point touched_;
  std::set<std::string> held_;
  bool last_ = false;
};

}  // namespace nodal
