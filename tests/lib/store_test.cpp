// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/store.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <chrono>
#include <optional>
#include <set>

#include <nodal/provenance.h>
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

TEST(Store, MakesItsDirectoryAndIsEmptyAtFirst) {
  const TemporaryDirectory temporary;
  const Store store(temporary.path() / "a" / "b");
  EXPECT_TRUE(fs::is_directory(temporary.path() / "a" / "b"));
  EXPECT_TRUE(files_in(temporary.path() / "a" / "b").empty());
  EXPECT_TRUE(store.records().empty());
  EXPECT_TRUE(store.warnings().empty());
  EXPECT_EQ(store.manifest(), Value());
  EXPECT_EQ(store.find("x"), nullptr);
}

TEST(Store, KeepsWhatWasAppended) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  for (int i = 0; i < 5; ++i) store.append(record_of("key" + std::to_string(i), i));
  const Store again(temporary.path());
  for (const Store* s : std::initializer_list<const Store*>{&store, &again}) {
    ASSERT_EQ(keys_of(*s), (Keys{"key0", "key1", "key2", "key3", "key4"}));
    ASSERT_NE(s->find("key3"), nullptr);
    toy::expect_equal(*s->find("key3"), record_of("key3", 3));
    EXPECT_EQ(s->find("key5"), nullptr);
    EXPECT_TRUE(s->warnings().empty());
  }
}

TEST(Store, HasEachRecordOnDiskWhenAppendReturns) {
  const TemporaryDirectory temporary;
  Store writer(temporary.path());
  for (int i = 0; i < 3; ++i) {
    writer.append(record_of("key" + std::to_string(i)));
    EXPECT_EQ(Store(temporary.path()).records().size(), static_cast<std::size_t>(i + 1));
  }
}

TEST(Store, GivesEveryWriterAFileOfItsOwn) {
  const TemporaryDirectory temporary;
  Store a(temporary.path());
  a.append(record_of("a"));
  ::usleep(2000);  // names hold the millisecond
  Store b(temporary.path());
  b.append(record_of("b"));
  a.append(record_of("c"));
  EXPECT_EQ(files_in(temporary.path() / "trials").size(), 2u);
  const Keys all = keys_of(Store(temporary.path()));
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()), (std::set<std::string>{"a", "b", "c"}));
}

TrialRecord attempt_of(const std::string& key, std::int64_t attempt, int repeat) {
  TrialRecord record = record_of(key, repeat);
  record.attempt = attempt;
  return record;
}

// Copying a store changes the files' times and their order in the directory, but not their names.
TEST(Store, ReadsFilesInTheOrderInWhichTheyWereBegun) {
  const TemporaryDirectory temporary;
  const fs::path first = temporary.path() / "trials" / "z-7-999.jsonl",
                 second = temporary.path() / "trials" / "a-8-1000.jsonl";
  write(first, to_json_line(record_of("same", 1)) + "\n" + to_json_line(record_of("old")) + "\n");
  write(second, to_json_line(record_of("new")) + "\n" + to_json_line(record_of("same", 2)) + "\n");
  write(temporary.path() / "trials" / "notes.txt", "not ours\n");
  for (const auto& [old_file, new_file] : {std::pair(first, second), std::pair(second, first)}) {
    fs::last_write_time(old_file, fs::last_write_time(new_file) - std::chrono::hours(1));
    const Store store(temporary.path());
    EXPECT_EQ(keys_of(store), (Keys{"same", "old", "new"}));
    EXPECT_EQ(store.find("same")->repeat, 1);  // of equal attempts the first
    EXPECT_TRUE(store.warnings().empty());
  }
}

TEST(Store, CountsTheLatestAttemptWhereverItStands) {
  const TemporaryDirectory temporary;
  write(temporary.path() / "trials" / "a-1-1.jsonl", to_json_line(attempt_of("k", 3, 33)) + "\n");
  write(temporary.path() / "trials" / "a-1-2.jsonl",
        to_json_line(attempt_of("k", 1, 11)) + "\n" + to_json_line(attempt_of("k", 2, 22)) + "\n");
  Store store(temporary.path());
  EXPECT_EQ(store.records().size(), 1u);
  EXPECT_EQ(store.find("k")->repeat, 33);
  store.append(attempt_of("k", 4, 44));
  EXPECT_EQ(store.find("k")->repeat, 44);
  EXPECT_EQ(store.records().size(), 1u);
  EXPECT_EQ(Store(temporary.path()).find("k")->repeat, 44);
}

TEST(Store, KeepsTheFirstOfTwoEqualKeysWhenAppending) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  store.append(record_of("same", 1));
  store.append(record_of("same", 2));
  EXPECT_EQ(store.records().size(), 1u);
  EXPECT_EQ(Store(temporary.path()).find("same")->repeat, 1);
}

TEST(Store, OpensOnlyWhatIsAStoreAndCreatesNothing) {
  const TemporaryDirectory temporary;
  const fs::path nowhere = temporary.path() / "nowhere";
  for (const fs::path& path : {nowhere, temporary.path()})
    EXPECT_EQ(
        message_of([&] { (void)Store::open_existing(path); }),
        "'" + path.string() + "' is not a store: it has no manifest.json; give the directory that nodal compare wrote");
  EXPECT_FALSE(fs::exists(nowhere));
  write(temporary.path() / "manifest.json", "{\"schema\": 1}\n");
  const Store store = Store::open_existing(temporary.path());
  EXPECT_EQ(store.directory(), temporary.path());
  EXPECT_EQ(files_in(temporary.path()).size(), 1u);
}

TEST(Store, DescribesItsStudyInTheManifest) {
  const TemporaryDirectory temporary;
  const Study study = toy_study();
  Store store(temporary.path());
  store.begin(study);
  const Store again = Store::open_existing(temporary.path());
  EXPECT_EQ(again.manifest(), store.manifest());
  const Value& m = again.manifest();
  EXPECT_EQ(m.at("schema").integer(), 1);
  EXPECT_EQ(m.at("study").at("name").text(), "toys");
  EXPECT_EQ(m.at("study").at("text").text(), study.text);
  EXPECT_EQ(m.at("study").at("file").text(), "s.toml");
  EXPECT_EQ(m.at("study").at("directory").text(), fs::absolute(".").string());
  EXPECT_EQ(to_json(m.at("problems")), R"([{"label":"bowl","kind":"bowl","options":{"size":3,"even":false},)"
                                       R"("best_known":{"quality":0.0,"origin":"by construction"}}])");
  EXPECT_EQ(to_json(m.at("optimizers")),
            R"([{"label":"halving","use":"halving","baseline":true,"multi_start":false,"deterministic":true,)"
            R"("options":{"factor":0.5}},{"label":"w","use":"wanderer","baseline":false,"multi_start":false,)"
            R"("deterministic":false,"options":{}}])");
  EXPECT_EQ(to_json(m.at("left_out")),
            R"([{"label":"nlopt-x","use":"nlopt-x","reason":"needs NLopt: configure with -DNODAL_NLOPT=ON"}])");
  ASSERT_EQ(m.at("keys").list().size(), 4u);
  EXPECT_EQ(m.at("keys").list()[0].text(), trial_key(study, all_trials(study)[0]));
  ASSERT_EQ(m.at("runs").list().size(), 1u);
  EXPECT_EQ(m.at("runs").list()[0].at("provenance"), provenance());
  EXPECT_EQ(m.at("runs").list()[0].at("build").text(), build_id(provenance()));
  EXPECT_EQ(m.at("runs").list()[0].at("began").text().size(), std::string("2024-01-01T00:00:00Z").size());
}

TEST(Store, AddsARunToTheManifestEveryTime) {
  const TemporaryDirectory temporary;
  Study study = toy_study();
  Store(temporary.path()).begin(study);
  study.repeats = 3;
  Store(temporary.path()).begin(study);
  const Store store(temporary.path());
  EXPECT_EQ(store.manifest().at("runs").list().size(), 2u);
  EXPECT_EQ(store.manifest().at("keys").list().size(), 6u);
}

TEST(Store, ReadsWhatWasStoredBetweenItsOpeningAndItsBeginning) {
  const TemporaryDirectory temporary;
  const Study study = toy_study();
  Store late(temporary.path());
  Store early(temporary.path());
  early.append(record_of("a"));
  EXPECT_EQ(late.find("a"), nullptr);
  late.begin(study);
  EXPECT_NE(late.find("a"), nullptr);
  EXPECT_EQ(late.records().size(), 1u);
}

// Of a trial that the study asks for.
TrialRecord wanted_record(std::optional<Conditions> conditions) {
  const Study study = toy_study();
  TrialRecord record = record_of(trial_key(study, all_trials(study)[0]));
  record.conditions = std::move(conditions);
  record.optimizer = "halving";
  return record;
}

// A store whose manifest says that its runs so far were another's.
Store store_of_another(const fs::path& directory, const char* what, const char* name,
                       const std::optional<TrialRecord>& record) {
  Store first(directory);
  first.begin(toy_study());
  if (record) first.append(*record);
  Value manifest = first.manifest();
  Value run = manifest.at("runs").list()[0], other = run.at("provenance");
  other.set(what, name);
  run.set("provenance", other);
  manifest.set("runs", Value::List{run});
  write(directory / "manifest.json", to_json(manifest));
  return Store(directory);
}

Store store_of_another_build(const fs::path& directory, bool with_results) {
  return store_of_another(directory, "revision", "abc123",
                          with_results ? std::optional(wanted_record(std::nullopt)) : std::nullopt);
}

TEST(Store, WarnsOfResultsOfAnotherBuild) {
  const TemporaryDirectory temporary;
  Store store = store_of_another_build(temporary.path(), true);
  EXPECT_TRUE(store.warnings().empty());
  store.begin(toy_study());
  const std::string program = ", program " + provenance().at("executable").text().substr(0, 8);
  const auto expected = [&](const std::string& whose) {
    return Keys{"'" + temporary.path().string() + "' holds results of another build (revision abc123" + program +
                "; the " + whose + " is revision " + revision() + program +
                "): halving (1). Results and times may differ; --rerun LABEL or --fresh runs them again"};
  };
  EXPECT_EQ(store.warnings(), expected("present one"));
  EXPECT_EQ(Store::open_existing(temporary.path()).warnings(), expected("last run's"));
}

TEST(Store, WarnsOfResultsOfAChangedProgram) {
  const TemporaryDirectory temporary;
  Store store = store_of_another(temporary.path(), "executable", "0123456789abcdef", wanted_record(std::nullopt));
  store.begin(toy_study());
  ASSERT_EQ(store.warnings().size(), 1u);
  EXPECT_NE(
      store.warnings()[0].find("another build (revision " + revision() + ", program 01234567; the present one is"),
      std::string::npos)
      << store.warnings()[0];
}

TEST(Store, SaysOfWhichTrialsAnotherBuildIs) {
  const TemporaryDirectory temporary;
  Store store = store_of_another_build(temporary.path(), false);
  const Value here = provenance();
  store.begin(toy_study());
  store.append(wanted_record(Conditions{build_id(here), here.at("processor").text(), 1, 2, false, false}));
  EXPECT_TRUE(Store::open_existing(temporary.path()).warnings().empty());
  TrialRecord other = wanted_record(Conditions{"of nobody", here.at("processor").text(), 1, 2, false, false});
  other.attempt = 3;
  store.append(other);
  const Store again = Store::open_existing(temporary.path());
  ASSERT_EQ(again.warnings().size(), 1u);
  EXPECT_NE(again.warnings()[0].find("another build (unknown; "), std::string::npos) << again.warnings()[0];
  EXPECT_NE(again.warnings()[0].find("halving (1)"), std::string::npos) << again.warnings()[0];
}

TEST(Store, WarnsOfResultsOfAnotherProcessor) {
  const TemporaryDirectory temporary;
  const Value here = provenance();
  Store store(temporary.path());
  store.append(wanted_record(Conditions{build_id(here), "An Older Processor", 1, 2, false, false}));
  store.begin(toy_study());
  EXPECT_EQ(store.warnings(),
            (Keys{"'" + temporary.path().string() +
                  "' holds results of another processor (An Older Processor; the present one is " +
                  here.at("processor").text() +
                  "): halving (1). Times don't compare, and last digits differ where a study leaves the choice of "
                  "instructions to the machine"}));
}

TEST(Store, WarnsOfAnotherProcessorInARunWhoseRecordsDoNotSay) {
  const TemporaryDirectory temporary;
  Store store = store_of_another(temporary.path(), "processor", "An Older Processor", wanted_record(std::nullopt));
  store.begin(toy_study());
  ASSERT_EQ(store.warnings().size(), 1u);
  EXPECT_NE(store.warnings()[0].find("another processor (An Older Processor; "), std::string::npos);
}

TEST(Store, WarnsOfNothingWhenAnotherBuildLeftNoResults) {
  const TemporaryDirectory temporary;
  Store store = store_of_another_build(temporary.path(), false);
  store.begin(toy_study());
  EXPECT_TRUE(store.warnings().empty());
}

TEST(Store, WarnsOfNothingWhenTheBuildIsTheSame) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  store.begin(toy_study());
  store.append(record_of("a"));
  store.begin(toy_study());
  EXPECT_TRUE(store.warnings().empty());
}

TEST(Store, ReplacesAFileAtOnce) {
  const TemporaryDirectory temporary;
  Store store(temporary.path());
  store.write_file("report.html", "old");
  store.write_file("report.html", "new");
  store.write_file("figures/plate.svg", "<svg/>");
  EXPECT_EQ(read(temporary.path() / "report.html"), "new");
  EXPECT_EQ(read(temporary.path() / "figures" / "plate.svg"), "<svg/>");
  EXPECT_EQ(files_in(temporary.path()).size(), 2u);
}

TEST(Store, KeepsTheRunsOfEveryoneWhoBegan) {
  const TemporaryDirectory temporary;
  Store a(temporary.path()), b(temporary.path());
  a.begin(toy_study());
  b.begin(toy_study());
  EXPECT_EQ(Store(temporary.path()).manifest().at("runs").list().size(), 2u);
}

TEST(Store, WarnsOfAnotherStudyInItsPlace) {
  const TemporaryDirectory temporary;
  Study study = toy_study();
  study.path = "/one/s.toml";
  Store(temporary.path()).begin(study);
  const auto warnings_of = [&](const Study& next) {
    Store store(temporary.path());
    store.begin(next);
    const Keys warnings = store.warnings();
    Store(temporary.path()).begin(study);  // as it was
    return warnings;
  };
  EXPECT_TRUE(warnings_of(study).empty());
  Study edited = study, moved = study, other = study;
  edited.text += "\n# edited\n";
  moved.path = other.path = "/two/s.toml";
  other.text += "\n# another\n";
  EXPECT_TRUE(warnings_of(edited).empty());
  EXPECT_TRUE(warnings_of(moved).empty());
  EXPECT_EQ(warnings_of(other),
            (Keys{"'" + temporary.path().string() +
                  "' holds results of the study 'toys' from '/one/s.toml'; this one is 'toys' from '/two/s.toml': the "
                  "report will show this one only; --out DIR keeps them apart"}));
}

TEST(Store, CanBeMoved) {
  const TemporaryDirectory temporary;
  Store a(temporary.path());
  a.append(record_of("a"));
  Store b = std::move(a);
  b.append(record_of("b"));
  EXPECT_EQ(keys_of(b), (Keys{"a", "b"}));
}

}  // namespace
}  // namespace nodal
