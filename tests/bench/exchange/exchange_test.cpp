// SPDX-License-Identifier: GPL-3.0-or-later
// Files for other benchmarks' tools, of trials that nobody ran.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include <exchange/format.h>

#include "../../lib/toy_store.h"
#include "../../support/temporary_directory.h"
#include "read_back.h"

namespace nodal::exchange {
namespace {

using toy::TemporaryDirectory;

TrialRecord trial(const std::string& problem, const std::string& optimizer, int repeat, std::vector<TracePoint> trace,
                  std::int64_t evaluations, std::size_t dimension = 3) {
  TrialRecord record;
  record.key = problem + optimizer + std::to_string(repeat);
  record.problem = problem;
  record.optimizer = optimizer;
  record.use = "some-method";
  record.repeat = repeat;
  record.end = End::budget;
  record.counts.evaluations = evaluations;
  record.seconds.total = 0.5;
  record.work.factorizations = 40;
  if (!trace.empty()) {
    record.start.quality = trace.front().quality;
    record.best = BestPoint{trace.back().evaluation, {}, std::vector<double>(dimension, 0.25)};
    record.best->summary.quality = trace.back().quality;
  }
  record.trace = std::move(trace);
  return record;
}

Value manifest(std::vector<std::pair<std::string, std::optional<double>>> problems, Value::List optimizers) {
  Value::List list;
  for (const auto& [label, quality] : problems) {
    Value problem;
    problem.set("label", label);
    if (quality) problem.set("best_known", Value::Table{{"quality", *quality}, {"origin", "a test"}});
    list.push_back(problem);
  }
  Value result;
  result.set("problems", std::move(list));
  result.set("optimizers", std::move(optimizers));
  return result;
}

Value labelled(const std::string& label) { return Value::Table{{"label", label}}; }

// Two problems, of which one knows its best quality; three optimizers, of which one has no trial.
MergedStores two_problems() {
  MergedStores stores;
  stores.manifest = manifest({{"plate", 1.0}, {"gear", std::nullopt}},
                             {labelled("fast, 'it' is"), labelled("idle"), labelled("slow")});
  const std::string fast = "fast, 'it' is";
  stores.records = {trial("plate", fast, 1, {{0, 1e-3, 1, 9.0}, {4, 2e-3, 5, 1.5}, {30, 3e-3, 31, 1.0}}, 32),
                    trial("plate", fast, 0, {{0, 1e-3, 1, 11.0}, {7, 2e-3, 8, 3.0}}, 7),
                    trial("gear", fast, 0, {{0, 1e-3, 1, 5.0}, {2, 2e-3, 2, 4.0}}, 100, 2),
                    trial("plate", "slow", 0, {{0, 1e-3, 1, 11.0}, {900, 0.1, 8, 1.25}}, 5000),
                    trial("gear", "slow", 0, {{0, 1e-3, 1, 5.0}, {2, 2e-3, 2, 4.5}}, 2, 2)};
  return stores;
}

std::map<std::string, std::string> files_of(const Experiment& experiment, const Format& format) {
  std::map<std::string, std::string> files;
  format.write(experiment, [&](const std::filesystem::path& path, std::string_view content) {
    EXPECT_TRUE(files.emplace(path.string(), content).second) << path << " is written twice";
  });
  return files;
}

void write_below(const TemporaryDirectory& folder, const std::map<std::string, std::string>& files) {
  for (const auto& [path, content] : files) toy::write(folder.path() / path, content);
}

read_back::Read read(const Format& format, const std::filesystem::path& folder) {
  return format.name == "coco" ? read_back::read_coco(folder) : read_back::read_ioh(folder);
}

read_back::Read written_and_read(const MergedStores& stores, const Format& format) {
  const TemporaryDirectory folder;
  write_below(folder, files_of(make_experiment(stores), format));
  return read(format, folder.path());
}

const read_back::DataSet& set_of(const read_back::Read& read, std::int64_t function, std::size_t runs) {
  for (const read_back::DataSet& set : read.sets)
    if (set.function == function && set.runs.size() == runs) return set;
  throw std::logic_error("no such data set");
}

class Formats : public testing::TestWithParam<std::string> {
 protected:
  const Format& format() const { return *std::ranges::find(formats(), GetParam(), &Format::name); }
};
INSTANTIATE_TEST_SUITE_P(All, Formats, testing::Values("coco", "ioh"), [](const auto& param) { return param.param; });

TEST_P(Formats, KeepTheRulesOfTheirReaders) {
  const read_back::Read back = written_and_read(two_problems(), format());
  EXPECT_EQ(back.faults, std::vector<std::string>());
  EXPECT_EQ(back.sets.size(), 4u);
}

TEST_P(Formats, HaveTheRunsWithTheirPrecisions) {
  const read_back::Read back = written_and_read(two_problems(), format());
  const read_back::DataSet& plate = set_of(back, 1, 2);
  EXPECT_EQ(plate.dimension, 3);
  const read_back::Run& second = plate.runs.at(1);
  EXPECT_EQ(second.instance, 2);
  EXPECT_EQ(second.evaluations, 33);  // the start is the first
  ASSERT_EQ(second.rows.size(), 4u);
  EXPECT_EQ(second.rows[1].evaluation, 5);
  EXPECT_EQ(second.rows[0].precision, 8.0);
  EXPECT_EQ(second.rows[1].precision, 0.5);
  EXPECT_EQ(second.rows[2].precision, 0.0);
  EXPECT_EQ(second.rows[3].precision, 0.0);
  EXPECT_EQ(plate.runs[0].rows.size(), 2u);  // ends with an improvement
}

// Nobody knows the gear's best quality: it is that of the best trial, 4.
TEST_P(Formats, MeasureFromTheBestOfTheTrialsWhereNoneIsKnown) {
  const read_back::Read back = written_and_read(two_problems(), format());
  for (const read_back::DataSet& set : back.sets)
    if (set.function == 2) {
      EXPECT_EQ(set.runs[0].rows[0].precision, 1.0) << set.algorithm;
    }
}

TEST_P(Formats, AreTheSameEachTime) {
  EXPECT_TRUE(files_of(make_experiment(two_problems()), format()) ==
              files_of(make_experiment(two_problems()), format()));
}

// Its process died: no figures. Its start could not be evaluated: none until evaluation 3.
TEST_P(Formats, HaveRunsOfTrialsWithoutFigures) {
  MergedStores stores = two_problems();
  stores.records.push_back(trial("plate", "lost", 0, {}, 0));
  stores.records.push_back(trial("plate", "late", 0, {{3, 1e-3, 1, 2.0}}, 5));
  const read_back::Read back = written_and_read(stores, format());
  EXPECT_EQ(back.faults, std::vector<std::string>());
  for (const read_back::DataSet& set : back.sets) {
    if (set.algorithm != "lost" && set.algorithm != "late") continue;
    EXPECT_EQ(set.runs[0].rows[0].precision, 3e21);
    EXPECT_EQ(set.runs[0].rows.size(), set.algorithm == "lost" ? 1u : 3u);
  }
}

TEST(Exchange, SaysWhatItMeasuresFrom) {
  MergedStores stores = two_problems();
  stores.manifest = manifest({{"plate", 1.5}, {"gear", std::nullopt}, {"none", 1.0}}, {});
  stores.records.push_back(trial("plate", "lost", 0, {}, 0));
  const Experiment experiment = make_experiment(stores);
  ASSERT_EQ(experiment.warnings.size(), 4u);
  EXPECT_EQ(experiment.warnings[0], "problem 'plate': precision is measured from 1, of a trial; G* = 1.5 was beaten");
  EXPECT_EQ(experiment.warnings[1],
            "problem 'gear' knows no best quality: precision is measured from that of the best of these trials");
  EXPECT_EQ(experiment.warnings[2], "problem 'none' is left out: no trial of it has a point");
  EXPECT_EQ(experiment.warnings[3], "1 trial left no figures: written as runs of one evaluation that found nothing");
}

TEST(Exchange, GivesEveryOptimizerAFolderOfItsOwn) {
  MergedStores stores = two_problems();
  stores.records.push_back(trial("plate", "slow", 1, {{0, 0.1, 1, 2.0}}, 5));
  for (const char* label : {"a/b", "a b", "..", "ä"})
    stores.records.push_back(trial("plate", label, 0, {{0, 0.1, 1, 2.0}}, 5));
  std::vector<std::string> folders;
  for (const Algorithm& algorithm : make_experiment(stores).algorithms) folders.push_back(algorithm.folder);
  EXPECT_EQ(folders, (std::vector<std::string>{"fast_it_is", "slow", "a_b", "a_b-2", "_.", "_"}));
}

TEST(Coco, IsWhatItsLoggerWrites) {
  const auto files = files_of(make_experiment(two_problems()), formats()[0]);
  EXPECT_EQ(
      files.at("slow/bbobexp_f1.info"),
      "suite = 'bbob', funcId = 1, DIM = 3, Precision = 1.000e-08, algId = 'slow', logger = 'bbob', data_format = "
      "'bbob-new2'\n% some-method on plate\ndata_f1/bbobexp_f1_DIM3.dat, 1:5001|2.5e-01\n");
  EXPECT_EQ(
      files.at("slow/data_f1/bbobexp_f1_DIM3.dat"),
      "% f evaluations | g evaluations | best noise-free fitness - Fopt (1.000000000000e+00) + sum g_i+ | measured "
      "fitness | best measured fitness or single-digit g-values | x1 | x2...\n"
      "1 0 +1.000000000e+01 +1.100000000e+01 +1.100000000e+01\n"
      "901 0 +2.500000000e-01 +1.250000000e+00 +1.250000000e+00\n"
      "5001 0 +2.500000000e-01 +1.250000000e+00 +1.250000000e+00\n");
}

TEST(Coco, HasTheBestSoFarAtTwentyTimesADecade) {
  const TemporaryDirectory folder;
  write_below(folder, files_of(make_experiment(two_problems()), formats()[0]));
  std::vector<std::int64_t> times;
  double at_891 = 0.0, at_1000 = 0.0;
  for (const std::string& line : read_back::lines_of(folder.path() / "slow/data_f1/bbobexp_f1_DIM3.tdat")) {
    if (line.starts_with('%')) continue;
    read_back::Read unused;
    const std::vector<double> row = read_back::numbers_of(line, "", unused);
    times.push_back(static_cast<std::int64_t>(row[0]));
    if (row[0] == 891) at_891 = row[2];
    if (row[0] == 1000) at_1000 = row[2];
  }
  EXPECT_EQ(times.front(), 1);
  EXPECT_EQ(times.back(), 5001);
  EXPECT_EQ(std::ranges::count_if(times, [](std::int64_t t) { return 100 <= t && t < 1000; }), 20);
  EXPECT_EQ(at_891, 10.0);
  EXPECT_EQ(at_1000, 0.25);
}

TEST(Ioh, HasSecondsAndQualitiesBesideThePrecision) {
  const auto files = files_of(make_experiment(two_problems()), formats()[1]);
  EXPECT_EQ(
      files.at("slow/data_f1_plate/IOHprofiler_f1_DIM3.dat"),
      "evaluations raw_y transformed_y seconds factorizations\n1 10 11 0.001 1\n901 0.25 1.25 0.1 8\n5001 0.25 1.25 "
      "0.5 40\n");
}

// The readers are worth something where they find what is wrong.
struct Damage {
  const char *name, *format, *file, *old_text, *new_text, *fault;
};
class Readers : public testing::TestWithParam<Damage> {};

TEST_P(Readers, FindFault) {
  const Damage& damage = GetParam();
  const Format& format = *std::ranges::find(formats(), std::string_view(damage.format), &Format::name);
  auto files = files_of(make_experiment(two_problems()), format);
  std::string& text = files.at(damage.file);
  const std::size_t place = text.find(damage.old_text);
  ASSERT_NE(place, std::string::npos);
  text.replace(place, std::string_view(damage.old_text).size(), damage.new_text);
  const TemporaryDirectory folder;
  write_below(folder, files);
  std::string faults;
  for (const std::string& fault : read(format, folder.path()).faults) faults += fault + "\n";
  EXPECT_NE(faults.find(damage.fault), std::string::npos) << faults;
}

INSTANTIATE_TEST_SUITE_P(
    All, Readers,
    testing::Values(
        Damage{"Suite", "coco", "slow/bbobexp_f1.info", "'bbob'", "'nodal'", "a suite that cocopp doesn't know"},
        Damage{"Comment", "coco", "slow/bbobexp_f1.info", "\n% ", "\n", "begins with %"},
        Damage{"Evaluations", "coco", "slow/bbobexp_f1.info", "1:5001|", "1:5000|", "maxevals"},
        Damage{"Precision", "coco", "slow/bbobexp_f1.info", "|2.5e-01", "|2.3e-01", "to its two digits"},
        Damage{"File", "coco", "slow/bbobexp_f1.info", "data_f1", "data_f7", "is not there"},
        Damage{"Comma", "coco", "slow/bbobexp_f1.info", "'slow'", "'sl,ow'", "a comma in the value of algId"},
        Damage{"FirstLine", "coco", "slow/data_f1/bbobexp_f1_DIM3.dat", "\n1 0", "\n2 0", "begins at evaluation 1"},
        Damage{"Rising", "coco", "slow/data_f1/bbobexp_f1_DIM3.tdat", "\n5001 0 +2.5", "\n5001 0 +2.6", "can't rise"},
        Damage{"Runs", "coco", "slow/bbobexp_f1.info", ", 1:", ", 1:1|2.5e-01, 1:", "another number of runs"},
        Damage{"Version", "ioh", "slow/IOHprofiler_f1_plate.json", "0.3.23", "0.3.2", "an older version"},
        Damage{"Columns", "ioh", "slow/IOHprofiler_f1_plate.json", "raw_y", "y", "begin with evaluations and raw_y"},
        Damage{"Best", "ioh", "slow/IOHprofiler_f1_plate.json", "\"evals\": 901", "\"evals\": 900",
               "'best' is no line"},
        Damage{"Text", "ioh", "slow/IOHprofiler_f1_plate.json", "\"best_quality\": \"1.0\"",
               "\"best_quality\": \"exit()\"", "is no number"},
        Damage{"Header", "ioh", "slow/data_f1_plate/IOHprofiler_f1_DIM3.dat", "raw_y ", "", "is no line of a run"}),
    [](const auto& damage) { return std::string(damage.param.format) + damage.param.name; });

}  // namespace
}  // namespace nodal::exchange
