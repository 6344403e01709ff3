// SPDX-License-Identifier: GPL-3.0-or-later
// Who runs which trial of a shared store, and what becomes of the claims of those that are gone.
#include "trial_claims.h"

#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "../support/temporary_directory.h"

namespace nodal {
namespace {

namespace fs = std::filesystem;
using toy::TemporaryDirectory;
using Answer = TrialClaims::Answer;

constexpr std::chrono::minutes kPatience{10};
const std::string kKey(32, 'a'), kOtherKey(32, 'b');
const char* const kElsewhere = "elsewhere-4026531836-7-1700000000000";

// Another process that has claimed a trial and lives until it is killed.
class Claimant {
 public:
  Claimant(const fs::path& store, const std::string& key) {
    int ready[2];
    if (::pipe(ready) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    char byte = 'x';
    if (process_ == 0) {
      TrialClaims claims(store, kPatience);
      (void)claims.claim(key, 1);
      (void)!::write(ready[1], &byte, 1);
      for (;;) ::pause();
    }
    (void)!::read(ready[0], &byte, 1);
    for (const int descriptor : ready) ::close(descriptor);
  }
  ~Claimant() { kill(); }
  void kill() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = 0;
  }

 private:
  pid_t process_ = 0;
};

void write_file(const fs::path& file, const std::string& content) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << content;
}

void age(const fs::path& file) { fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1)); }

TEST(TrialClaims, AreTakenOverAtOnceFromAProcessThatDied) {
  const TemporaryDirectory store;
  Claimant other(store.path(), kKey);
  TrialClaims claims(store.path(), kPatience);
  EXPECT_EQ(claims.claim(kKey, 1), Answer::others);
  EXPECT_EQ(claims.claim(kKey, 2), Answer::granted) << "another attempt is another claim";
  EXPECT_EQ(claims.claim(kOtherKey, 1), Answer::granted);
  other.kill();
  EXPECT_EQ(claims.claim(kKey, 1), Answer::granted);
}

// Nobody knows whether it lives: it is silent, or not.
TEST(TrialClaims, OfAnotherMachineStandWhileItGivesSignsOfLife) {
  const TemporaryDirectory store;
  const fs::path folder = store.path() / "claims", sign = folder / (std::string(kElsewhere) + ".alive");
  write_file(sign, "");
  write_file(folder / (kKey + ".1"), kElsewhere);
  write_file(folder / (kOtherKey + ".1"), "done");
  TrialClaims claims(store.path(), kPatience);
  EXPECT_EQ(claims.claim(kKey, 1), Answer::others);
  EXPECT_EQ(claims.claim(kOtherKey, 1), Answer::done) << "who comes doesn't clear what is in use";
  age(sign);
  EXPECT_EQ(claims.claim(kKey, 1), Answer::granted);
}

TEST(TrialClaims, OfNobodyWhoLivesAreClearedByWhoComes) {
  const TemporaryDirectory store;
  const fs::path folder = store.path() / "claims", sign = folder / (std::string(kElsewhere) + ".alive");
  write_file(sign, "");
  age(sign);
  write_file(folder / (kKey + ".1"), "done");
  TrialClaims claims(store.path(), kPatience);
  EXPECT_FALSE(fs::exists(sign));
  EXPECT_EQ(claims.claim(kKey, 1), Answer::granted) << "its record may be gone, too";
}

TEST(TrialClaims, LastOneLeavesNothingOthersStay) {
  const TemporaryDirectory store;
  {
    TrialClaims claims(store.path(), kPatience);
    (void)claims.claim(kKey, 1);
    claims.done(kKey, 1);
    claims.leave_last();
  }
  EXPECT_FALSE(fs::exists(store.path() / "claims"));
  const Claimant other(store.path(), kKey);
  {
    TrialClaims claims(store.path(), kPatience);
    claims.leave_last();
  }
  EXPECT_TRUE(fs::exists(store.path() / "claims" / (kKey + ".1"))) << "somebody has come since it was last";
}

TEST(TrialClaims, ClearOnlyWhatTheyMake) {
  const TemporaryDirectory store;
  const fs::path folder = store.path() / "claims";
  const std::string owner = kElsewhere;
  const std::vector<std::string> foreign = {
      "movie.part", "thesis.new",        "bread.stale", "of.alive", "a.1", "movie.0123456789abcdef.7.part",
      kKey,         kKey + ".1.old.txt", "notes.txt"};
  const std::vector<std::string> own = {owner + ".new", owner + ".stale", owner + ".new.0123456789abcdef.7.part",
                                        kKey + ".1.0123456789abcdef.7.part", kKey + ".12"};
  for (const auto* names : {&foreign, &own})
    for (const std::string& name : *names) write_file(folder / name, "x");
  {
    TrialClaims claims(store.path(), kPatience);
    claims.leave_last();
  }
  for (const std::string& name : foreign) EXPECT_TRUE(fs::exists(folder / name)) << name;
  for (const std::string& name : own) EXPECT_FALSE(fs::exists(folder / name)) << name;
}

// Whoever lacks locks may have taken it for dead.
TEST(TrialClaims, GiveANewSignOfLifeWhereTheirsIsGone) {
  const TemporaryDirectory store;
  TrialClaims claims(store.path(), kPatience);
  fs::path sign;
  for (const auto& entry : fs::directory_iterator(store.path() / "claims")) sign = entry.path();
  ASSERT_EQ(sign.extension(), ".alive");
  fs::remove(sign);
  for (int i = 0; i < 40 && !fs::exists(sign); ++i) {
    ::usleep(100000);
    claims.beat();
  }
  EXPECT_TRUE(fs::exists(sign));
}

}  // namespace
}  // namespace nodal
