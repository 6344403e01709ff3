// SPDX-License-Identifier: GPL-3.0-or-later
// Stores that are damaged, newer, in the way, or on a full disk.
#include <nodal/store.h>

#include <gtest/gtest.h>

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <limits>

#include <nodal/trial.h>

#include "../support/messages.h"
#include "../support/temporary_directory.h"
#include "toy_store.h"

namespace nodal {
namespace {

namespace fs = std::filesystem;
using toy::files_in;
using toy::Keys;
using toy::keys_of;
using toy::message_of;
using toy::read;
using toy::record_of;
using toy::TemporaryDirectory;
using toy::toy_study;
using toy::write;

// While it lives no file grows beyond `bytes`: writing then fails as it does on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : old_handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_limit_);
    rlimit limit = old_limit_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_limit_);
    ::signal(SIGXFSZ, old_handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*old_handler_)(int);
  rlimit old_limit_{};
};

TEST(StoreFaults, TrialsAndResultsAreNotWrittenElsewhere) {
  for (const char* name : {"trials", "claims", "cache"}) {
    const TemporaryDirectory folder;
    fs::create_directories(folder.path() / "store");
    fs::create_directories(folder.path() / "elsewhere");
    fs::create_directory_symlink(folder.path() / "elsewhere", folder.path() / "store" / name);
    Store store(folder.path() / "store");
    std::string message;
    try {
      store.begin(toy_study());
    } catch (const StoreError& error) {
      message = error.what();
    }
    EXPECT_NE(message.find(std::string("store/") + name + "': it is a link; remove it"), std::string::npos) << message;
    EXPECT_TRUE(fs::is_empty(folder.path() / "elsewhere"));
  }
}

TEST(Store, DropsALineThatWasCutOffWhereverThatWas) {
  const TemporaryDirectory temporary;
  const fs::path file = temporary.path() / "trials" / "x.jsonl";
  const std::string whole = to_json_line(record_of("first")) + "\n", last = to_json_line(record_of("last"));
  std::vector<std::size_t> cuts = {0, 1, last.size() - 1, last.size()};
  for (std::size_t cut = 2; cut < last.size(); cut += 23) cuts.push_back(cut);
  for (const std::size_t cut : cuts) {
    write(file, whole + last.substr(0, cut));
    const Store store(temporary.path());
    if (cut == last.size()) {  // only the newline is missing: nothing is lost
      EXPECT_EQ(keys_of(store), (Keys{"first", "last"}));
    } else {
      ASSERT_EQ(keys_of(store), Keys{"first"}) << cut;
    }
    if (cut == 0 || cut == last.size()) {
      EXPECT_TRUE(store.warnings().empty());
    } else {
      ASSERT_EQ(store.warnings(),
                (Keys{file.string() + ":2: a line that is no whole record was dropped; its trial counts as not run"}));
    }
  }
}

TEST(Store, DropsGarbledLinesAndKeepsTheOthers) {
  const TemporaryDirectory temporary;
  const fs::path file = temporary.path() / "trials" / "x.jsonl";
  std::string nul = to_json_line(record_of("nul"));
  nul[20] = '\0';
  write(file, to_json_line(record_of("a")) + "\n{\"schema\": 1}\n\n" + nul + "\n" + to_json_line(record_of("b")) +
                  "\nnoise\xff\n");
  const Store store(temporary.path());
  EXPECT_EQ(keys_of(store), (Keys{"a", "b"}));
  const std::string dropped = ": a line that is no whole record was dropped; its trial counts as not run";
  EXPECT_EQ(store.warnings(),
            (Keys{file.string() +
                      ":2: a line that is no whole record was dropped (not a trial's record: 'key' is missing); its "
                      "trial counts as not run",
                  file.string() + ":4" + dropped, file.string() + ":6" + dropped}));
}

TEST(Store, AppendsToAStoreWhoseLastLineWasCutOff) {
  const TemporaryDirectory temporary;
  write(temporary.path() / "trials" / "x.jsonl", to_json_line(record_of("a")) + "\n{\"schema\":1,\"key\":\"b");
  {
    Store store(temporary.path());
    store.append(record_of("b"));
  }
  const Store store(temporary.path());
  EXPECT_NE(store.find("a"), nullptr);
  EXPECT_NE(store.find("b"), nullptr);
  EXPECT_EQ(store.warnings().size(), 1u);
}

// A line whose key can still be read is spoken of until that trial has run; any other as long as a trial is missing.
TEST(Store, WarnsOfADroppedLineUntilItsTrialHasRun) {
  const TemporaryDirectory temporary;
  const Study study = toy_study();
  const std::vector<Trial> trials = all_trials(study);
  const std::string torn = to_json_line(record_of(trial_key(study, trials[0])));
  {
    Store store(temporary.path());
    store.begin(study);
    for (std::size_t i = 1; i + 1 < trials.size(); ++i) store.append(record_of(trial_key(study, trials[i])));
  }
  write(temporary.path() / "trials" / "x.jsonl", torn.substr(0, torn.size() / 2) + "\nnoise\n");
  const auto warnings = [&] { return Store(temporary.path()).warnings().size(); };
  EXPECT_EQ(warnings(), 2u);
  ::usleep(2000);  // names hold the millisecond
  Store(temporary.path()).append(record_of(trial_key(study, trials[0])));
  EXPECT_EQ(warnings(), 1u);  // the noise may have been the other missing trial
  ::usleep(2000);
  Store(temporary.path()).append(record_of(trial_key(study, trials.back())));
  EXPECT_EQ(warnings(), 0u);
}

TEST(Store, EndsALineThatSomebodyLeftUnfinished) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  store.append(record_of("a"));
  const fs::path file = files_in(temporary.path() / "trials").at(0);
  std::ofstream(file, std::ios::app) << "GARBAGE";
  store.append(record_of("b"));
  EXPECT_EQ(keys_of(Store(temporary.path())), (Keys{"a", "b"}));
  EXPECT_EQ(read(file), to_json_line(record_of("a")) + "\nGARBAGE\n" + to_json_line(record_of("b")) + "\n");
}

TEST(Store, RemovesWhatDeadWritersLeft) {
  const TemporaryDirectory temporary;
  const pid_t dead = ::fork();
  if (dead == 0) ::_exit(0);
  ::waitpid(dead, nullptr, 0);
  const fs::path abandoned = temporary.path() / ("report.html." + std::to_string(dead) + ".part"),
                 young = temporary.path() / ("summary.csv." + std::to_string(dead) + ".part"),
                 at_work = temporary.path() / ("report.html." + std::to_string(::getpid()) + ".part"),
                 own = temporary.path() / "notes.part";
  for (const fs::path& file : {abandoned, young, at_work, own}) {
    write(file, "half");
    if (file != young) fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::minutes(2));
  }
  Store(temporary.path()).begin(toy_study());
  EXPECT_FALSE(fs::exists(abandoned));
  for (const fs::path& file : {young, at_work, own}) EXPECT_TRUE(fs::exists(file)) << file;
}

TEST(Store, RefusesWhatWouldMakeItWait) {
  for (const char* name : {"manifest.json", "trials/x.jsonl"}) {
    const TemporaryDirectory temporary;
    const fs::path file = temporary.path() / name;
    fs::create_directories(file.parent_path());
    const std::string refusal = "cannot read '" + file.string() + "': not a regular file; copy its content into one";
    ASSERT_EQ(::mkfifo(file.c_str(), 0666), 0);
    EXPECT_EQ(message_of([&] { Store{temporary.path()}; }), refusal);
    fs::remove(file);
    fs::create_symlink("/dev/zero", file);
    EXPECT_EQ(message_of([&] { Store{temporary.path()}; }), refusal);
  }
}

std::string moved_or_removed(const fs::path& directory) {
  return "the store '" + directory.string() + "' was moved or removed while trials ran; what it held is where it went";
}

TEST(Store, NoticesThatItWasRemoved) {
  const TemporaryDirectory temporary;
  const fs::path directory = temporary.path() / "store";
  Store store(directory);
  store.begin(toy_study());
  store.append(record_of("a"));
  fs::remove_all(directory);
  EXPECT_EQ(message_of<StoreError>([&] { store.append(record_of("b")); }), moved_or_removed(directory));
  EXPECT_EQ(message_of<StoreError>([&] { store.write_file("report.html", "x"); }), moved_or_removed(directory));
  EXPECT_FALSE(fs::exists(directory));
}

TEST(Store, NoticesThatItWasMovedAndAnotherStandsInItsPlace) {
  for (const bool with_a_manifest : {false, true}) {
    const TemporaryDirectory temporary;
    const fs::path directory = temporary.path() / "store", elsewhere = temporary.path() / "elsewhere";
    Store store(directory);
    store.begin(toy_study());
    store.append(record_of("a"));
    fs::rename(directory, elsewhere);
    fs::create_directory(directory);
    if (with_a_manifest) fs::copy_file(elsewhere / "manifest.json", directory / "manifest.json");
    EXPECT_EQ(message_of<StoreError>([&] { store.append(record_of("b")); }), moved_or_removed(directory));
    EXPECT_EQ(keys_of(Store(elsewhere)), Keys{"a"});
    EXPECT_EQ(files_in(directory).size(), with_a_manifest ? 1u : 0u);
  }
}

// Only its file of trials is gone: the lines in it are, too.
TEST(Store, DoesNotBeginItsFileAgain) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  store.append(record_of("a"));
  const fs::path file = files_in(temporary.path() / "trials").at(0);
  fs::remove(file);
  EXPECT_EQ(message_of<StoreError>([&] { store.append(record_of("b")); }),
            "'" + file.string() +
                "' was removed while trials ran, and with it what they had stored there; run the comparison again: it "
                "runs what the store lacks");
}

TEST(Store, SaysWhenItCantBeLocked) {
  const TemporaryDirectory temporary;
  fs::create_directory(temporary.path() / ".lock");
  Store store(temporary.path());
  store.begin(toy_study());
  EXPECT_EQ(store.warnings(), (Keys{"'" + (temporary.path() / ".lock").string() +
                                    "' can't be locked (Is a directory): another comparison that writes here goes "
                                    "unnoticed"}));
}

TEST(Store, SeesAnotherProcessThatWrites) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  EXPECT_EQ(store.other_writer(), std::nullopt);
  store.begin(toy_study());
  EXPECT_EQ(store.other_writer(), std::nullopt);
  int began[2], end[2];
  ASSERT_EQ(::pipe(began), 0);
  ASSERT_EQ(::pipe(end), 0);
  const pid_t other = ::fork();
  if (other == 0) {
    char byte = 'x';
    Store theirs(temporary.path());
    theirs.begin(toy_study());
    const bool sees = theirs.other_writer() == std::optional<int>(::getppid());
    (void)!::write(began[1], &byte, 1);
    ::close(end[1]);
    (void)!::read(end[0], &byte, 1);
    ::_exit(sees ? 0 : 1);
  }
  char byte = 0;
  EXPECT_EQ(::read(began[0], &byte, 1), 1);
  EXPECT_EQ(store.other_writer(), std::optional<int>(other));
  ::close(end[1]);
  int status = 1;
  ::waitpid(other, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(store.other_writer(), std::nullopt);
  for (const int descriptor : {began[0], began[1], end[0]}) ::close(descriptor);
}

TEST(Store, LeavesANewerSchemaAlone) {
  const TemporaryDirectory temporary;
  const fs::path file = temporary.path() / "trials" / "x.jsonl";
  write(file, to_json_line(record_of("a")) + "\n{\"schema\": 9, \"wonders\": true}\n");
  EXPECT_EQ(
      message_of<NewerSchemaError>([&] { Store{temporary.path()}; }),
      file.string() + ":2: the record has schema 9, this build reads up to 1; use a newer nodal or another directory");
  fs::remove(file);
  const fs::path manifest = temporary.path() / "manifest.json";
  write(manifest, "{\"schema\": 2}");
  const std::string expected =
      "'" + manifest.string() + "' has schema 2, this build reads up to 1; use a newer nodal or another directory";
  EXPECT_EQ(message_of<NewerSchemaError>([&] { Store{temporary.path()}; }), expected);
  EXPECT_EQ(message_of<NewerSchemaError>([&] { (void)Store::open_existing(temporary.path()); }), expected);
  EXPECT_EQ(read(manifest), "{\"schema\": 2}");
}

TEST(Store, RefusesADirectoryThatIsAFile) {
  const TemporaryDirectory temporary;
  const fs::path file = temporary.path() / "file";
  write(file, "mine\n");
  EXPECT_EQ(message_of<StoreError>([&] { Store{file}; }),
            "cannot write '" + file.string() + "': Not a directory; what was stored before stays valid");
  EXPECT_EQ(message_of<StoreError>([&] { Store{file / "below"}; }),
            "cannot write '" + (file / "below").string() + "': Not a directory; what was stored before stays valid");
  EXPECT_EQ(read(file), "mine\n");
}

TEST(Store, RefusesADirectoryThatCannotBeMade) {
  EXPECT_EQ(message_of<StoreError>([] { Store{"/proc/nodal-test"}; }),
            "cannot write '/proc/nodal-test': No such file or directory; what was stored before stays valid");
}

TEST(Store, SaysWhereItCouldNotWrite) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  write(temporary.path() / "trials", "in the way");
  EXPECT_EQ(message_of<StoreError>([&] { store.append(record_of("a")); }),
            "cannot write '" + (temporary.path() / "trials").string() +
                "': Not a directory; what was stored before stays valid");
  EXPECT_TRUE(store.records().empty());
}

TEST(Store, SaysWhatItCouldNotRead) {
  const TemporaryDirectory temporary;
  const fs::path file = temporary.path() / "trials" / "x.jsonl", manifest = temporary.path() / "manifest.json";
  fs::create_directories(file);
  EXPECT_EQ(message_of([&] { Store{temporary.path()}; }), "cannot read '" + file.string() + "': Is a directory");
  fs::create_directories(manifest);
  EXPECT_EQ(message_of([&] { Store{temporary.path()}; }), "cannot read '" + manifest.string() + "': Is a directory");
}

TEST(Store, LosesOnlyTheLineThatAFullDiskCutOff) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  store.append(record_of("a"));
  const fs::path file = files_in(temporary.path() / "trials").at(0);
  const std::string before = read(file);
  {
    const FullDisk full(before.size() + 100);
    EXPECT_EQ(message_of<StoreError>([&] { store.append(record_of("b")); }),
              "cannot write '" + file.string() + "': File too large; what was stored before stays valid");
  }
  EXPECT_EQ(read(file), before);
  EXPECT_EQ(keys_of(store), Keys{"a"});
  store.append(record_of("c"));
  const Store again(temporary.path());
  EXPECT_EQ(keys_of(again), (Keys{"a", "c"}));
  EXPECT_TRUE(again.warnings().empty());
}

TEST(Store, WritesNothingOfARecordThatJsonCannotHold) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  TrialRecord record = record_of("a");
  record.best->summary.cost = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(store.append(record), std::logic_error);
  EXPECT_TRUE(store.records().empty());
  store.append(record_of("b"));
  EXPECT_EQ(keys_of(Store(temporary.path())), Keys{"b"});
}

TEST(Store, RefusesAManifestThatIsNone) {
  const TemporaryDirectory temporary;
  const fs::path manifest = temporary.path() / "manifest.json";
  for (const char* text : {"{}", "[]", "{\"schema\": \"1\"}"}) {
    write(manifest, text);
    EXPECT_EQ(message_of([&] { Store{temporary.path()}; }),
              "'" + manifest.string() + "' is not the manifest of a store: it has no schema; choose another directory");
  }
  write(manifest, "{\n\"schema\":");
  EXPECT_TRUE(message_of([&] { Store{temporary.path()}; }).starts_with(manifest.string() + ":2: not valid JSON: "));
}

TEST(Store, TakesAManifestWithDamagedRuns) {
  for (const char* runs : {"3", "[3]", "[{}]", "[{\"provenance\": 3}]"}) {
    const TemporaryDirectory temporary;
    write(temporary.path() / "manifest.json", "{\"schema\": 1, \"runs\": " + std::string(runs) + "}");
    Store store(temporary.path());
    store.append(record_of("a"));
    EXPECT_NO_THROW(store.begin(toy_study())) << runs;
  }
}

TEST(Store, KeepsAnOldReportWhenTheNewOneCannotBeWritten) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  store.write_file("report.html", "old");
  const std::string page = (temporary.path() / "report.html").string();
  {
    const FullDisk full(5);
    EXPECT_EQ(message_of<StoreError>([&] { store.write_file("report.html", "new and longer"); }),
              "cannot write '" + page + "': File too large; what was stored before stays valid");
    EXPECT_THROW(store.begin(toy_study()), StoreError);
  }
  EXPECT_EQ(read(temporary.path() / "report.html"), "old");
  EXPECT_EQ(files_in(temporary.path()).size(), 2u);  // with the lock; nothing half-written is left
  EXPECT_EQ(store.manifest(), Value());
}

TEST(Store, LeavesNoScrapsWhereADirectoryIsInTheWay) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  fs::create_directories(temporary.path() / "report.html" / "x");
  EXPECT_EQ(message_of<StoreError>([&] { store.write_file("report.html", "new"); }),
            "cannot write '" + (temporary.path() / "report.html").string() + "': it is no regular file; remove it");
  EXPECT_EQ(files_in(temporary.path()).size(), 1u);
}

}  // namespace
}  // namespace nodal
