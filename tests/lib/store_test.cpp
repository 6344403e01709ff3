// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/store.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <chrono>
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

TEST(Store, ReadsTheOldestFileFirstAndCountsTheFirstOfTwoEqualKeys) {
  const TemporaryDirectory temporary;
  const fs::path old_file = temporary.path() / "trials" / "z.jsonl", new_file = temporary.path() / "trials" / "a.jsonl";
  write(old_file, to_json_line(record_of("same", 1)) + "\n" + to_json_line(record_of("old")) + "\n");
  write(new_file, to_json_line(record_of("new")) + "\n" + to_json_line(record_of("same", 2)) + "\n");
  write(temporary.path() / "trials" / "notes.txt", "not ours\n");
  fs::last_write_time(old_file, fs::last_write_time(new_file) - std::chrono::hours(1));
  const Store store(temporary.path());
  EXPECT_EQ(keys_of(store), (Keys{"same", "old", "new"}));
  EXPECT_EQ(store.find("same")->repeat, 1);
  EXPECT_TRUE(store.warnings().empty());
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
  EXPECT_EQ(to_json(m.at("optimizers")), R"([{"label":"halving","use":"halving","baseline":true,"multi_start":false},)"
                                         R"({"label":"w","use":"wanderer","baseline":false,"multi_start":false}])");
  EXPECT_EQ(to_json(m.at("left_out")),
            R"([{"label":"nlopt-x","use":"nlopt-x","reason":"needs NLopt: configure with -DNODAL_NLOPT=ON"}])");
  ASSERT_EQ(m.at("keys").list().size(), 4u);
  EXPECT_EQ(m.at("keys").list()[0].text(), trial_key(study, all_trials(study)[0]));
  ASSERT_EQ(m.at("runs").list().size(), 1u);
  EXPECT_EQ(m.at("runs").list()[0].at("provenance"), provenance());
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

Store store_of_another_build(const fs::path& directory, bool with_results) {
  Store first(directory);
  first.begin(toy_study());
  if (with_results) first.append(record_of("a"));
  Value manifest = first.manifest();
  Value run = manifest.at("runs").list()[0], other = run.at("provenance");
  other.set("revision", "abc123");
  run.set("provenance", other);
  manifest.set("runs", Value::List{run});
  write(directory / "manifest.json", to_json(manifest));
  return Store(directory);
}

TEST(Store, WarnsOfResultsOfAnotherBuild) {
  const TemporaryDirectory temporary;
  Store store = store_of_another_build(temporary.path(), true);
  EXPECT_TRUE(store.warnings().empty());
  store.begin(toy_study());
  EXPECT_EQ(store.warnings(),
            (Keys{"'" + temporary.path().string() + "' holds results of another build (revision abc123; this is " +
                  revision() + "): times don't compare"}));
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
