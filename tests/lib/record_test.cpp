// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/record.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <nodal/random.h>

#include "../support/messages.h"
#include "toy_record.h"

namespace nodal {
namespace {

std::string refusal(const std::string& line) {
  return toy::message_of([&] { (void)parse_record(line, "a.jsonl:3"); });
}

Value full_value() { return parse_json(to_json_line(toy::full_record()), "full"); }

// The table in which a dotted path ends, and its last part.
std::pair<Value*, std::string> owner_of(Value& root, const std::string& path) {
  const std::size_t dot = path.find('.');
  if (dot == std::string::npos) return {&root, path};
  return {const_cast<Value*>(root.find(path.substr(0, dot))), path.substr(dot + 1)};
}

std::string refusal_without(const std::string& path) {
  Value value = full_value();
  const auto [table, key] = owner_of(value, path);
  std::erase_if(table->table(), [&key = key](const auto& entry) { return entry.first == key; });
  return refusal(to_json(value));
}

std::string refusal_with(const std::string& path, Value other) {
  Value value = full_value();
  const auto [table, key] = owner_of(value, path);
  table->set(key, std::move(other));
  return refusal(to_json(value));
}

TEST(Record, IsOneLineWithTheFieldsInTheirOrder) {
  const std::string line = to_json_line(toy::full_record());
  EXPECT_EQ(line.find('\n'), std::string::npos);
  std::vector<std::string> keys;
  const Value value = full_value();
  for (const auto& [key, part] : value.table()) keys.push_back(key);
  EXPECT_EQ(keys,
            (std::vector<std::string>{"schema", "key",     "attempt",    "problem", "optimizer", "use",    "repeat",
                                      "seed",   "end",     "reason",     "options", "start",     "best",   "counts",
                                      "work",   "seconds", "conditions", "trace",   "claimed",   "health", "unseen"}));
}

TEST(Record, SurvivesTheRoundTripWhenFull) {
  const TrialRecord record = toy::full_record();
  const TrialRecord back = parse_record(to_json_line(record), "line");
  toy::expect_equal(back, record);
  EXPECT_EQ(to_json_line(back), to_json_line(record));
}

TEST(Record, SurvivesTheRoundTripWhenEmpty) {
  const TrialRecord record;
  const TrialRecord back = parse_record(to_json_line(record), "line");
  toy::expect_equal(back, record);
  EXPECT_EQ(to_json_line(back), to_json_line(record));
  EXPECT_FALSE(back.conditions || back.best || back.claimed || back.start.cost || back.health.drift);
}

TEST(Record, SurvivesTheRoundTripWithAnyNumbers) {
  RandomStream random(5);
  for (int i = 0; i < 300; ++i) {
    TrialRecord record = toy::full_record();
    record.seed = random() >> 11;  // below 2^53, as every seed is
    record.end = static_cast<End>(random.index(6));
    record.best->x.resize(random.index(5));
    for (double& x : record.best->x)
      x = std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.index(2000)) - 1000);
    record.trace.clear();
    for (std::size_t n = random.index(4); n > 0; --n)
      record.trace.push_back(
          {static_cast<std::int64_t>(random() >> 1), random.uniform(), static_cast<std::int64_t>(n), random.uniform()});
    if (random.index(2) == 0) record.claimed->cost.reset();
    if (random.index(2) == 0) record.start.relative_error.reset();
    const TrialRecord back = parse_record(to_json_line(record), "line");
    toy::expect_equal(back, record);
    ASSERT_EQ(to_json_line(back), to_json_line(record));
  }
}

TEST(Record, KeepsAReasonInWhateverEncoding) {
  TrialRecord record = toy::full_record();
  record.reason = "ferm\xE9 \"\n\t\x01";
  EXPECT_EQ(parse_record(to_json_line(record), "line").reason, "ferm\xEF\xBF\xBD \"\n\t\x01");
}

TEST(Record, NeverHoldsNanOrInfinity) {
  TrialRecord record = toy::full_record();
  record.best->summary.quality = std::nan("");
  EXPECT_THROW((void)to_json_line(record), std::logic_error);
  record = toy::full_record();
  record.trace.back().quality = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)to_json_line(record), std::logic_error);
}

TEST(Record, RefusesALineWithoutAFieldByItsName) {
  for (const char* path : {"schema",
                           "key",
                           "problem",
                           "optimizer",
                           "use",
                           "repeat",
                           "seed",
                           "end",
                           "reason",
                           "options",
                           "start",
                           "counts",
                           "work",
                           "seconds",
                           "trace",
                           "health",
                           "best.x",
                           "best.evaluation",
                           "counts.values",
                           "work.flops",
                           "work.flops_per_value",
                           "seconds.cpu",
                           "conditions.build",
                           "conditions.processor",
                           "conditions.jobs",
                           "conditions.cores",
                           "claimed.status",
                           "health.refused"})
    EXPECT_EQ(refusal_without(path), "a.jsonl:3: not a trial's record: '" + std::string(path) + "' is missing");
}

// The next attempt is one more: what can't be counted on is no record.
TEST(Record, RefusesAttemptsThatCantBeCounted) {
  TrialRecord record = toy::full_record();
  for (const std::int64_t attempt : {std::int64_t{0}, std::int64_t{-5}, std::numeric_limits<std::int64_t>::max()}) {
    record.attempt = attempt;
    EXPECT_THROW((void)parse_record(to_json_line(record), "r"), InputError) << attempt;
  }
}

TEST(Record, ReadsALineWithoutWhatWasNotMeasured) {
  for (const char* path :
       {"best", "claimed", "start.cost", "start.quality", "best.relative_error", "best.at_bounds", "best.data_quality",
        "claimed.cost", "claimed.x_equals_best", "claimed.evaluations", "attempt", "conditions",
        "conditions.beside_others", "conditions.stopped", "health.drift", "health.spread"})
    EXPECT_EQ(refusal_without(path), "(nothing was thrown)") << path;
}

TEST(Record, RefusesAWrongTypeByItsName) {
  const auto about = [](const std::string& what) { return "a.jsonl:3: not a trial's record: " + what; };
  EXPECT_EQ(refusal_with("key", 3), about("'key' is not a text"));
  EXPECT_EQ(refusal_with("repeat", 1.5), about("'repeat' is not an integer"));
  EXPECT_EQ(refusal_with("schema", -7), about("its schema is -7"));
  EXPECT_EQ(refusal_with("schema", 0), about("its schema is 0"));
  EXPECT_EQ(refusal_with("repeat", Value(std::int64_t{1} << 40)), about("'repeat' is out of its range"));
  EXPECT_EQ(refusal_with("seed", -1), about("'seed' is out of its range"));
  EXPECT_EQ(refusal_with("seed", "7"), about("'seed' is not an integer"));
  EXPECT_EQ(refusal_with("end", "stopped"), about("'end' is not the name of an end"));
  EXPECT_EQ(refusal_with("end", 1), about("'end' is not the name of an end"));
  EXPECT_EQ(refusal_with("options", Value::List{}), about("'options' is not a table"));
  EXPECT_EQ(refusal_with("start", 1.0), about("'start' is not a table"));
  EXPECT_EQ(refusal_with("start.cost", "1"), about("'start.cost' is not a number"));
  EXPECT_EQ(refusal_with("best", Value::List{}), about("'best' is not a table"));
  EXPECT_EQ(refusal_with("best.data_quality", "1"), about("'best.data_quality' is not a number"));
  EXPECT_EQ(refusal_with("best.x", 1.0), about("'best.x' is not a list"));
  EXPECT_EQ(refusal_with("best.x", Value::List{Value("1")}), about("'best.x' holds something else than numbers"));
  EXPECT_EQ(refusal_with("claimed.x_equals_best", 1), about("'claimed.x_equals_best' is not a boolean"));
  EXPECT_EQ(refusal_with("trace", 1), about("'trace' is not a list"));
  const std::string trace = about("'trace' holds something else than [evaluation, seconds, factorizations, quality]");
  EXPECT_EQ(refusal_with("trace", Value::List{Value(1)}), trace);
  EXPECT_EQ(refusal_with("trace", Value::List{Value(Value::List{Value(1), Value(0.1), Value(1)})}), trace);
  EXPECT_EQ(refusal_with("trace", Value::List{Value(Value::List{Value(1.5), Value(0.1), Value(1), Value(1.0)})}),
            trace);
  EXPECT_EQ(refusal("[]"), about("it is no table"));
  EXPECT_EQ(refusal("{}"), about("'schema' is missing"));
  EXPECT_TRUE(refusal("{").starts_with("a.jsonl:3:1: not valid JSON: ")) << refusal("{");
}

TEST(Record, TakesAnIntegerWhereANumberIsMeant) {
  Value value = full_value();
  const_cast<Value*>(value.find("seconds"))->set("total", 2);
  EXPECT_EQ(parse_record(to_json(value), "line").seconds.total, 2.0);
}

TEST(Record, ReadsPastFieldsThatItDoesNotKnow) { EXPECT_EQ(refusal_with("remark", "by hand"), "(nothing was thrown)"); }

TEST(Record, OfANewerSchemaIsLeftAlone) {
  Value value;
  value.set("schema", kRecordSchema + 1);
  EXPECT_EQ(toy::message_of<NewerSchemaError>([&] { (void)parse_record(to_json(value), "a.jsonl:3"); }),
            "a.jsonl:3: the record has schema 2, this build reads up to 1; use a newer nodal or another directory");
}

TEST(Record, SaysNothingOfWhatIsUsual) {
  TrialRecord record = toy::full_record();
  record.attempt = 1;
  record.conditions = Conditions{"b", "p", 1, 2, false, false};
  const Value value = parse_json(to_json_line(record), "line");
  EXPECT_EQ(value.find("attempt"), nullptr);
  EXPECT_EQ(to_json(value.at("conditions")), R"({"build":"b","processor":"p","jobs":1,"cores":2})");
  toy::expect_equal(parse_record(to_json_line(record), "line"), record);
}

TrialRecord with_times(double total, double cpu, std::optional<Conditions> conditions = std::nullopt) {
  TrialRecord record = toy::full_record();
  record.seconds.total = total;
  record.seconds.cpu = cpu;
  record.conditions = std::move(conditions);
  return record;
}

TEST(Contamination, IsLessThanNineTenthsOfACoreWhereTheClockCanTell) {
  EXPECT_EQ(contamination(with_times(1.0, 0.9)), "");
  EXPECT_EQ(contamination(with_times(1.0, 2.0)), "");
  EXPECT_EQ(contamination(with_times(1.0, 0.894)), "got 0.89 of a core");
  EXPECT_EQ(contamination(with_times(0.02, 0.01)), "got 0.50 of a core");
  EXPECT_EQ(contamination(with_times(0.0199, 0.001)), "");
  EXPECT_EQ(contamination(TrialRecord{}), "");
}

TEST(Contamination, IsSharingCoresAndBeingStoppedToo) {
  EXPECT_EQ(contamination(with_times(1.0, 1.0, Conditions{"b", "p", 2, 2, false, false})), "");
  EXPECT_EQ(contamination(with_times(1.0, 1.0, Conditions{"b", "p", 2, 1, false, false})), "2 jobs shared 1 core");
  EXPECT_EQ(contamination(with_times(0.001, 0.0, Conditions{"b", "p", 3, 2, true, true})),
            "was stopped while it ran; 3 jobs shared 2 cores; another comparison ran beside it");
  EXPECT_EQ(contamination(with_times(1.0, 0.25, Conditions{"b", "p", 1, 2, false, true})),
            "was stopped while it ran; got 0.25 of a core");
}

TEST(Contamination, IsASlowCore) {
  Conditions conditions{"b", "p", 1, 2, false, false};
  conditions.pace = 1.15;
  EXPECT_EQ(contamination(with_times(1.0, 1.0, conditions)), "");
  conditions.pace = 1.3;
  EXPECT_EQ(contamination(with_times(1.0, 1.0, conditions)),
            "ran when its core was 1.30 times as slow as at its fastest");
}

TEST(Contamination, IsACoreTakenFromAShortTrial) {
  Conditions conditions{"b", "p", 1, 2, false, false};
  conditions.preempted = 0;
  EXPECT_EQ(contamination(with_times(0.004, 0.002, conditions)), "");
  conditions.preempted = 1;
  EXPECT_EQ(contamination(with_times(0.004, 0.002, conditions)), "got 0.50 of a core");
  EXPECT_EQ(contamination(with_times(0.004, 0.0039, conditions)), "");
}

TEST(Record, HasAnErrorForEveryNameOfItsUnseenPoints) {
  EXPECT_NE(refusal_with("unseen.names", Value(Value::List{"a", "b", "c"})).find("2 errors for 3 names"),
            std::string::npos);
  EXPECT_NE(refusal_with("unseen.names", Value(Value::List{"a"})).find("names too few things"), std::string::npos);
  EXPECT_NE(
      refusal_with("unseen.points", Value(Value::List{Value(Value::List{Value(1), Value(2.0)})})).find("unseen.points"),
      std::string::npos);
}

TEST(Record, NamesEveryEnd) {
  const std::pair<End, const char*> names[] = {{End::budget, "budget"},     {End::target, "target"},
                                               {End::finished, "finished"}, {End::failed, "failed"},
                                               {End::timeout, "timeout"},   {End::crashed, "crashed"}};
  for (const auto& [end, name] : names) EXPECT_EQ(to_string(end), name);
}

}  // namespace
}  // namespace nodal
