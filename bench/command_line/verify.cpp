// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include <nodal/compare.h>
#include <nodal/provenance.h>
#include <nodal/random.h>
#include <nodal/verify.h>

#include "commands.h"
#include "console.h"
#include "stop_signal.h"
#include "stored_study.h"

namespace nodal {

namespace {

namespace fs = std::filesystem;

// A store for the trials that run again, gone with it.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "nodal-verify-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw StoreError(fmt::format("cannot make a directory like '{}'", name));
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] const fs::path& path() const noexcept { return path_; }

 private:
  fs::path path_;
};

// Those of the study that are stored.
std::vector<std::string> stored_keys(const Study& study, const Store& store) {
  std::vector<std::string> keys;
  for (const Trial& trial : all_trials(study))
    if (std::string key = trial_key(study, trial); store.find(key)) keys.push_back(std::move(key));
  if (keys.empty())
    throw InputError(fmt::format("'{}' holds no trial that its study asks for", store.directory().string()));
  return keys;
}

// Some of them, drawn by the seed.
std::vector<std::string> sample(std::vector<std::string> keys, const VerifyArguments& arguments) {
  RandomStream random(arguments.seed);
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) std::swap(keys[i], keys[i + random.index(keys.size() - i)]);
  keys.resize(std::min(keys.size(), arguments.trials));
  return keys;
}

// Where a record comes from this build on this processor, its trial must do the same to the last bit.
double tolerance_of(const TrialRecord& stored, const Value& here) {
  const bool same = stored.conditions && stored.conditions->build == build_id(here) &&
                    stored.conditions->processor == here.at("processor").text();
  return same ? 0.0 : kAcrossMachines;
}

std::string name_of(const TrialRecord& record) {
  return fmt::format("{} on {}, repeat {}", record.optimizer, record.problem, record.repeat);
}

// What is said of each, and of all.
class Found {
 public:
  void add(const TrialRecord& stored, const SameTrial& result, double tolerance) {
    across_ += tolerance > 0.0;
    if (!result.difference.empty()) {
      ++differing_;
      std::cout << fmt::format("DIFFERS  {}: {}\n", name_of(stored), result.difference);
    } else if (!result.checked) {
      ++unchecked_;
      std::cout << fmt::format("NOT CHECKED  {}: the clock ended it before anything could be compared\n",
                               name_of(stored));
    } else {
      ++same_;
      std::cout << fmt::format("same     {}: {} points until evaluation {}\n", name_of(stored), result.points,
                               result.evaluations);
    }
  }

  [[nodiscard]] std::string summary() const {
    std::string text = fmt::format("{} of {} trials do the same again", same_, same_ + differing_ + unchecked_);
    text += across_ == 0 ? ", to the last bit"
                         : fmt::format("; {} of another build or processor, within {:g}", across_, kAcrossMachines);
    if (unchecked_ > 0) text += fmt::format("; {} could not be checked", unchecked_);
    return text + "\n";
  }

  [[nodiscard]] int exit_code() const { return differing_ > 0 || same_ == 0 ? kExitTrialFailed : 0; }

 private:
  std::size_t same_ = 0, differing_ = 0, unchecked_ = 0, across_ = 0;
};

}  // namespace

int verify_command(const VerifyArguments& arguments, const Registry& registry) {
  const Store store = Store::open_existing(arguments.directory);
  const Value* entry = store.manifest().find("study");
  if (!entry) throw InputError(fmt::format("the manifest of '{}' has no study", arguments.directory));
  const Study study = read_stored_study(*entry, registry, Cost::any);
  CompareOptions options;
  std::vector<std::string> keys = stored_keys(study, store);
  const std::size_t others = store.records().size() - keys.size();
  options.keys = sample(std::move(keys), arguments);
  const StopSignal stop;
  options.interrupted = &stop.flag();
  const Scratch scratch;
  Store again(scratch.path());
  if (compare(study, registry, again, options).interrupted) {
    std::cerr << "interrupted: nothing is said of any trial\n";
    return kExitInterrupted;
  }

  Found found;
  const Value here = provenance();
  for (const std::string& key : *options.keys) {
    const TrialRecord& stored = *store.find(key);
    const double tolerance = tolerance_of(stored, here);
    found.add(stored, same_trial(stored, *again.find(key), tolerance, study.budget.seconds.has_value()), tolerance);
  }
  std::cout << found.summary();
  if (others > 0)
    std::cout << fmt::format("{} other stored trials can't be checked: the study of '{}' doesn't ask for them\n",
                             others, arguments.directory);
  return found.exit_code();
}

}  // namespace nodal
