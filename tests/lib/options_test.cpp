// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/options.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "../support/messages.h"

namespace nodal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const OptionSchema kSchema = {
    {.name = "cooling",
     .default_value = 0.9,
     .minimum = 0.0,
     .maximum = 1.0,
     .minimum_excluded = true,
     .maximum_excluded = true},
    {.name = "share", .minimum = 0.0, .maximum = 1.0},
    {.name = "step", .default_text = "a tenth of the box", .minimum = 0.0, .minimum_excluded = true},
    {.name = "ceiling", .maximum = 10.0},
    {.name = "below", .maximum = 10.0, .maximum_excluded = true},
    {.name = "rounds", .type = OptionType::integer, .default_value = 12, .minimum = 1},
    {.name = "verbose", .type = OptionType::boolean, .default_value = false},
    {.name = "order", .type = OptionType::text, .default_value = "cyclic", .choices = {"cyclic", "random"}},
    {.name = "note", .type = OptionType::text},
    {.name = "size", .type = OptionType::number_list, .minimum = 0.0, .minimum_excluded = true, .length = 2},
    {.name = "counts",
     .type = OptionType::integer_list,
     .default_value = Value::List{Value(5), Value(5)},
     .minimum = 2},
    {.name = "material",
     .type = OptionType::table,
     .fields = {{.name = "young", .required = true, .help = "modulus of elasticity"},
                {.name = "poisson", .default_value = 0.3, .minimum = -1.0, .maximum = 0.5},
                {.name = "layer", .type = OptionType::table, .fields = {{.name = "depth", .minimum = 0.0}}}}},
    {.name = "names", .type = OptionType::text_list},
    {.name = "axes", .type = OptionType::text_list, .choices = {"x", "y"}},
    {.name = "outline", .type = OptionType::vector_list},
    {.name = "holes", .type = OptionType::vector_lists},
    {.name = "forces",
     .type = OptionType::table_list,
     .fields = {{.name = "node", .type = OptionType::integer, .required = true},
                {.name = "size", .default_value = 1.0}}},
    {.name = "start",
     .type = OptionType::text,
     .default_value = "paper",
     .choices = {"paper", "uniform"},
     .fields = {{.name = "file", .type = OptionType::text, .required = true}},
     .or_table = true},
};

// JSON gives values with their lines: the table begins on line 1.
Options resolve(std::string_view json) {
  return resolve_options(kSchema, parse_json(json, "s.toml"), "optimizer 'toy'");
}

std::string refusal(std::string_view json) {
  return toy::message_of([&] { (void)resolve(json); });
}

std::string refusal_of(const char* key, double number) {
  Value given, value(number);
  value.source = {"s.toml", 7};
  given.set(key, value);
  return toy::message_of([&] { (void)resolve_options(kSchema, given, "optimizer 'toy'"); });
}

TEST(Options, FillInDefaultsAndLeaveOutWhatHasNone) {
  const Options options = resolve("{}");
  EXPECT_EQ(to_json(options.values()),
            R"({"cooling":0.9,"rounds":12,"verbose":false,"order":"cyclic","counts":[5,5],"start":"paper"})");
  EXPECT_FALSE(options.has("share"));
  EXPECT_FALSE(options.has("material"));
}

TEST(Options, StandInTheOrderOfTheSchema) {
  EXPECT_EQ(
      to_json(resolve(R"({"order": "random", "verbose": true, "share": 1, "cooling": 0.5})").values()),
      R"({"cooling":0.5,"share":1.0,"rounds":12,"verbose":true,"order":"random","counts":[5,5],"start":"paper"})");
}

TEST(Options, ReadBackAsTheyWereGiven) {
  const Options options = resolve(R"({"cooling": 0.25, "rounds": 3, "verbose": true, "note": "any", "size": [4, 2.5],
      "counts": [2, 3, 4], "material": {"young": 2, "layer": {"depth": 1}}, "start": {"file": "k.json"}})");
  EXPECT_EQ(options.number("cooling"), 0.25);
  EXPECT_EQ(options.integer("rounds"), 3);
  EXPECT_TRUE(options.boolean("verbose"));
  EXPECT_EQ(options.text("note"), "any");
  EXPECT_EQ(options.numbers("size"), (std::vector<double>{4.0, 2.5}));
  EXPECT_EQ(options.numbers("counts"), (std::vector<double>{2.0, 3.0, 4.0}));
  EXPECT_EQ(options.table("material").number("young"), 2.0);
  EXPECT_EQ(options.table("material").number("poisson"), 0.3);
  EXPECT_EQ(options.table("material").table("layer").number("depth"), 1.0);
  EXPECT_EQ(options.table("start").text("file"), "k.json");
}

// A trial's key is a hash of its options: 1 and 1.0 must not make two trials.
TEST(Options, HoldANumberAsANumberHoweverItWasWritten) {
  EXPECT_EQ(to_canonical_json(resolve(R"({"share": 1, "size": [4, 4]})").values()),
            to_canonical_json(resolve(R"({"size": [4.0, 4.0], "share": 1.0})").values()));
}

TEST(Options, KnowWhereTheyWereSaid) {
  const Options options = resolve("{\"share\": 1,\n\"size\": [1,\n2],\n\"material\": {\n\"young\": 1}}");
  EXPECT_EQ(options.values().source.text(), "s.toml:1");
  EXPECT_EQ(options.at("share").source.text(), "s.toml:1");
  EXPECT_EQ(options.at("size").source.text(), "s.toml:2");
  EXPECT_EQ(options.at("size").list()[1].source.text(), "s.toml:3");
  EXPECT_EQ(options.at("material").source.text(), "s.toml:4");
  EXPECT_EQ(options.table("material").at("young").source.text(), "s.toml:5");
  EXPECT_EQ(options.at("cooling").source.text(), "s.toml:1");  // a default stands where its table does
}

// What a study says, though it be the default, isn't a default; resolved once more, both stay what they are.
TEST(Options, KnowWhatWasGiven) {
  Options options = resolve(R"({"rounds": 12, "verbose": false, "material": {"young": 1}})");
  for (int i = 0; i < 2; ++i) {
    for (const char* key : {"rounds", "verbose", "material"}) EXPECT_TRUE(options.given(key)) << key;
    for (const char* key : {"cooling", "order", "start", "step"}) EXPECT_FALSE(options.given(key)) << key;
    EXPECT_TRUE(options.table("material").given("young"));
    EXPECT_FALSE(options.table("material").given("poisson"));
    options = resolve_options(kSchema, options.values(), "optimizer 'toy'");
  }
}

TEST(Options, ThrowLogicErrorsForWhatTheSchemaLacks) {
  const Options options = resolve("{}");
  EXPECT_THROW((void)options.number("temperature"), std::logic_error);
  EXPECT_THROW((void)options.text("cooling"), std::logic_error);
  EXPECT_THROW((void)options.integer("cooling"), std::logic_error);
  EXPECT_THROW((void)options.table("order").text("file"), std::logic_error);
}

TEST(Options, RefuseAnUnknownKeyAndOfferTheNearest) {
  EXPECT_EQ(refusal("{\"share\": 1,\n\"coling\": 1}"),
            "s.toml:2: unknown key 'coling' in optimizer 'toy'; did you mean 'cooling' or 'ceiling'?");
  EXPECT_EQ(refusal(R"({"count": [1]})"), "s.toml:1: unknown key 'count' in optimizer 'toy'; did you mean 'counts'?");
  EXPECT_EQ(
      refusal(R"({"temperature": 1})"),
      "s.toml:1: unknown key 'temperature' in optimizer 'toy'; valid: 'cooling', 'share', 'step', 'ceiling', 'below', "
      "'rounds', 'verbose', 'order', 'note', 'size', 'counts', 'material' and 6 more");
  EXPECT_EQ(refusal(R"({"material": {"young": 1, "posson": 0.3}})"),
            "s.toml:1: unknown key 'posson' in 'material' of optimizer 'toy'; did you mean 'poisson'?");
  EXPECT_EQ(toy::message_of([] { (void)resolve_options({}, parse_json(R"({"a": 1})", "s.toml"), "optimizer 'bare'"); }),
            "s.toml:1: unknown key 'a' in optimizer 'bare'; it has no options");
}

TEST(Options, RefuseAWrongType) {
  EXPECT_EQ(refusal(R"({"share": "x"})"), "s.toml:1: 'share' of optimizer 'toy' must be a number, not a text");
  EXPECT_EQ(refusal(R"({"rounds": 1.0})"), "s.toml:1: 'rounds' of optimizer 'toy' must be an integer, not a number");
  EXPECT_EQ(refusal(R"({"verbose": 1})"),
            "s.toml:1: 'verbose' of optimizer 'toy' must be a boolean (true or false), not an integer");
  EXPECT_EQ(refusal(R"({"order": 1})"), "s.toml:1: 'order' of optimizer 'toy' must be a text, not an integer");
  EXPECT_EQ(refusal(R"({"note": {}})"), "s.toml:1: 'note' of optimizer 'toy' must be a text, not a table");
  EXPECT_EQ(refusal(R"({"size": 4})"), "s.toml:1: 'size' of optimizer 'toy' must be a list of numbers, not an integer");
  EXPECT_EQ(refusal(R"({"counts": {}})"),
            "s.toml:1: 'counts' of optimizer 'toy' must be a list of integers, not a table");
  EXPECT_EQ(refusal(R"({"material": [1]})"), "s.toml:1: 'material' of optimizer 'toy' must be a table, not a list");
  EXPECT_EQ(refusal(R"({"material": {"young": true}})"),
            "s.toml:1: 'young' of 'material' of optimizer 'toy' must be a number, not a boolean");
  EXPECT_EQ(refusal(R"({"start": 1})"),
            "s.toml:1: 'start' of optimizer 'toy' must be a text or a table, not an integer");
  EXPECT_EQ(refusal("[1]"), "s.toml:1: optimizer 'toy' must be a table, not a list");
}

TEST(Options, NameTheEntryOfAListThatIsWrong) {
  EXPECT_EQ(refusal("{\"size\": [1,\n\"2\"]}"),
            "s.toml:2: entry 2 of 'size' of optimizer 'toy' must be a number, not a text");
  EXPECT_EQ(refusal("{\"counts\":\n[3,\n2.5]}"),
            "s.toml:3: entry 2 of 'counts' of optimizer 'toy' must be an integer, not a number");
  EXPECT_EQ(refusal("{\"counts\":\n[1, 3]}"),
            "s.toml:2: entry 1 of 'counts' of optimizer 'toy' is 1; allowed: counts ≥ 2");
  EXPECT_EQ(refusal(R"({"size": [1, 0]})"), "s.toml:1: entry 2 of 'size' of optimizer 'toy' is 0; allowed: size > 0");
}

TEST(Options, RefuseNumbersThatAreNotFinite) {
  EXPECT_EQ(refusal_of("share", std::nan("")), "s.toml:7: 'share' of optimizer 'toy' must be finite, not nan");
  EXPECT_EQ(refusal_of("step", kInfinity), "s.toml:7: 'step' of optimizer 'toy' must be finite, not inf");
  EXPECT_EQ(refusal_of("ceiling", -kInfinity), "s.toml:7: 'ceiling' of optimizer 'toy' must be finite, not -inf");
}

TEST(Options, RefuseWhatIsOutOfRange) {
  EXPECT_EQ(refusal(R"({"share": -0.1})"), "s.toml:1: 'share' of optimizer 'toy' is -0.1; allowed: 0 ≤ share ≤ 1");
  EXPECT_EQ(refusal(R"({"share": 1.5})"), "s.toml:1: 'share' of optimizer 'toy' is 1.5; allowed: 0 ≤ share ≤ 1");
  EXPECT_EQ(refusal(R"({"cooling": 0})"), "s.toml:1: 'cooling' of optimizer 'toy' is 0; allowed: 0 < cooling < 1");
  EXPECT_EQ(refusal(R"({"cooling": 1})"), "s.toml:1: 'cooling' of optimizer 'toy' is 1; allowed: 0 < cooling < 1");
  EXPECT_EQ(refusal(R"({"step": 0})"), "s.toml:1: 'step' of optimizer 'toy' is 0; allowed: step > 0");
  EXPECT_EQ(refusal(R"({"ceiling": 10.5})"), "s.toml:1: 'ceiling' of optimizer 'toy' is 10.5; allowed: ceiling ≤ 10");
  EXPECT_EQ(refusal(R"({"below": 10})"), "s.toml:1: 'below' of optimizer 'toy' is 10; allowed: below < 10");
  EXPECT_EQ(refusal(R"({"rounds": 0})"), "s.toml:1: 'rounds' of optimizer 'toy' is 0; allowed: rounds ≥ 1");
  EXPECT_EQ(refusal(R"({"material": {"young": 1, "poisson": 0.6}})"),
            "s.toml:1: 'poisson' of 'material' of optimizer 'toy' is 0.6; allowed: -1 ≤ poisson ≤ 0.5");
}

TEST(Options, TakeTheEndsOfAClosedRange) {
  EXPECT_EQ(resolve(R"({"share": 0, "ceiling": 10, "rounds": 1})").number("share"), 0.0);
  EXPECT_EQ(resolve(R"({"share": 1})").number("share"), 1.0);
}

TEST(Options, RefuseAListOfTheWrongLength) {
  EXPECT_EQ(refusal(R"({"size": [1, 2, 3]})"), "s.toml:1: 'size' of optimizer 'toy' has 3 entries; it must have 2");
  EXPECT_EQ(refusal(R"({"size": []})"), "s.toml:1: 'size' of optimizer 'toy' has 0 entries; it must have 2");
}

TEST(Options, RefuseATextThatIsNoChoice) {
  EXPECT_EQ(refusal(R"({"order": "randm"})"),
            "s.toml:1: 'order' of optimizer 'toy' is 'randm'; did you mean 'random'?");
  EXPECT_EQ(refusal(R"({"order": "backwards"})"),
            "s.toml:1: 'order' of optimizer 'toy' is 'backwards'; valid: 'cyclic', 'random'");
  EXPECT_EQ(refusal(R"({"start": "unifrm"})"),
            "s.toml:1: 'start' of optimizer 'toy' is 'unifrm'; did you mean 'uniform'?");
}

TEST(Options, RefuseToGoWithoutWhatIsRequired) {
  EXPECT_EQ(refusal("{\n\"material\": {}}"),
            "s.toml:2: 'material' of optimizer 'toy' lacks 'young': modulus of elasticity");
  EXPECT_EQ(refusal(R"({"start": {}})"), "s.toml:1: 'start' of optimizer 'toy' lacks 'file'");
}

TEST(Options, CheckTheirOwnDefaults) {
  const OptionSchema wrong = {{.name = "a", .default_value = 2.0, .maximum = 1.0}};
  EXPECT_EQ(toy::message_of([&] { (void)resolve_options(wrong, parse_json("{}", "s.toml"), "it"); }),
            "s.toml:1: 'a' of it is 2; allowed: a ≤ 1");
}

TEST(RangeText, IsWrittenAsPeopleDo) {
  EXPECT_EQ(range_text({.name = "x"}), "");
  EXPECT_EQ(range_text({.name = "x", .minimum = 0.0, .maximum = 1.0, .minimum_excluded = true}), "0 < x ≤ 1");
  EXPECT_EQ(range_text({.name = "x", .minimum = 1e-4, .maximum = 1.0, .maximum_excluded = true}), "0.0001 ≤ x < 1");
  EXPECT_EQ(range_text({.name = "x", .minimum = 1.0}), "x ≥ 1");
  EXPECT_EQ(range_text({.name = "x", .minimum = 1.0, .minimum_excluded = true}), "x > 1");
  EXPECT_EQ(range_text({.name = "x", .maximum = 1.0}), "x ≤ 1");
  EXPECT_EQ(range_text({.name = "x", .maximum = 1.0, .maximum_excluded = true}), "x < 1");
}

TEST(NearestNames, AreAtMostThreeAndTheBestFirst) {
  const std::vector<std::string> names = {"nlopt-lbfgs", "annealing", "anneling", "annealin", "annealings", "x"};
  EXPECT_EQ(nearest_names("annealing", names), (std::vector<std::string>{"annealing", "annealings", "anneling"}));
  EXPECT_EQ(nearest_names("lbfgs", names), (std::vector<std::string>{"nlopt-lbfgs"}));
  EXPECT_TRUE(nearest_names("quadratic", names).empty());
  EXPECT_TRUE(nearest_names("", std::vector<std::string>{"annealing"}).empty());
  EXPECT_EQ(name_hint("anything", std::vector<std::string>{}), "");
}

TEST(Source, LeavesOutWhatIsNotKnown) {
  EXPECT_EQ((Source{"f.toml", 12}.text()), "f.toml:12");
  EXPECT_EQ((Source{"--seed", 0}.text()), "--seed");
  EXPECT_EQ(Source{}.text(), "");
  EXPECT_STREQ(InputError(Source{}, "what").what(), "what");
  EXPECT_STREQ(InputError(Source{"f", 1}, "what").what(), "f:1: what");
}

TEST(Options, ReadsVectorsAndListsOfThem) {
  const Options options = resolve(R"({"outline": [[0, 0], [4, 0.5]], "holes": [[[1, 1]], []]})");
  using Vectors = std::vector<std::vector<double>>;
  EXPECT_EQ(options.vectors("outline"), (Vectors{{0, 0}, {4, 0.5}}));
  EXPECT_EQ(options.vector_lists("holes"), (std::vector<Vectors>{{{1, 1}}, {}}));
}

TEST(Options, RefusesWhatIsNoVector) {
  EXPECT_EQ(refusal(R"({"outline": [[0, 0], [4]]})"),
            "s.toml:1: entry 2 of 'outline' of optimizer 'toy' must be a list of 2 numbers");
  EXPECT_EQ(refusal(R"({"outline": [[0, "a"]]})"),
            "s.toml:1: entry 2 of entry 1 of 'outline' of optimizer 'toy' must be a number, not a text");
  EXPECT_EQ(refusal(R"({"outline": 3})"),
            "s.toml:1: 'outline' of optimizer 'toy' must be a list of vectors of 2 numbers");
  EXPECT_EQ(refusal(R"({"holes": [3]})"),
            "s.toml:1: entry 1 of 'holes' of optimizer 'toy' must be a list of vectors of 2 numbers");
}

TEST(Options, ReadsATextAsAListOfOne) {
  using Texts = std::vector<std::string>;
  const Options one = resolve(R"({"names": "a"})"), many = resolve(R"({"names": ["a", "b"], "axes": "y"})");
  EXPECT_EQ(one.texts("names"), Texts{"a"});
  EXPECT_EQ(to_json(one.values()), to_json(resolve(R"({"names": ["a"]})").values()));
  EXPECT_EQ(many.texts("names"), (Texts{"a", "b"}));
  EXPECT_EQ(many.texts("axes"), Texts{"y"});
  EXPECT_EQ(resolve(R"({"names": []})").texts("names"), Texts{});
}

TEST(Options, RefusesWhatIsNoText) {
  EXPECT_EQ(refusal(R"({"names": 3})"),
            "s.toml:1: 'names' of optimizer 'toy' must be a text or a list of texts, not an integer");
  EXPECT_EQ(refusal(R"({"names": ["a", 3]})"),
            "s.toml:1: entry 2 of 'names' of optimizer 'toy' must be a text, not an integer");
  EXPECT_EQ(refusal(R"({"axes": "z"})"), "s.toml:1: 'axes' of optimizer 'toy' is 'z'; did you mean 'x' or 'y'?");
  EXPECT_EQ(refusal(R"({"axes": ["x", "z"]})"),
            "s.toml:1: entry 2 of 'axes' of optimizer 'toy' is 'z'; did you mean 'x' or 'y'?");
}

// Positions in the plane or in space, as a problem allows them.
TEST(Options, HoldsVectorsToTheirLengths) {
  const OptionSchema schema = {{.name = "at", .type = OptionType::vector_list, .entries = {2, 3}}};
  const auto read = [&](const char* json) { return resolve_options(schema, parse_json(json, "s"), "toy"); };
  EXPECT_EQ(read(R"({"at": [[1, 2], [1, 2, 3]]})").vectors("at"),
            (std::vector<std::vector<double>>{{1, 2}, {1, 2, 3}}));
  for (const char* wrong : {R"({"at": [[1]]})", R"({"at": [[1, 2, 3, 4]]})"}) {
    try {
      (void)read(wrong);
      ADD_FAILURE() << wrong;
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "s:1: entry 1 of 'at' of toy must be a list of 2 to 3 numbers");
    }
  }
}

TEST(Options, ReadsAListOfTables) {
  const Options options = resolve(R"({"forces": [{"node": 3}, {"node": 5, "size": 2}]})");
  const std::vector<Options> forces = options.tables("forces");
  ASSERT_EQ(forces.size(), 2u);
  EXPECT_EQ(forces[0].integer("node"), 3);
  EXPECT_EQ(forces[0].number("size"), 1.0);
  EXPECT_EQ(forces[1].number("size"), 2.0);
}

TEST(Options, RefusesAWrongTableOfAList) {
  EXPECT_EQ(refusal(R"({"forces": [{"node": 3}, {"node": 5, "sise": 2}]})"),
            "s.toml:1: unknown key 'sise' in entry 2 of 'forces' of optimizer 'toy'; did you mean 'size'?");
  EXPECT_EQ(refusal(R"({"forces": {"node": 3}})"),
            "s.toml:1: 'forces' of optimizer 'toy' must be a list of tables, not a table");
}

// Not only a text may be a table instead.
TEST(Options, TakeAListOrATable) {
  const OptionSchema schema = {{.name = "bounds",
                                .type = OptionType::number_list,
                                .length = 2,
                                .fields = {{.name = "factor", .required = true, .minimum = 1.0}},
                                .or_table = true}};
  const auto resolved = [&](std::string_view json) {
    return resolve_options(schema, parse_json(json, "s.toml"), "optimizer 'toy'");
  };
  EXPECT_EQ(resolved(R"({"bounds": [1, 2]})").numbers("bounds"), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(resolved(R"({"bounds": {"factor": 4}})").table("bounds").number("factor"), 4.0);
  const auto message = [&](std::string_view json) { return toy::message_of([&] { (void)resolved(json); }); };
  EXPECT_EQ(message(R"({"bounds": 3})"),
            "s.toml:1: 'bounds' of optimizer 'toy' must be a list of numbers or a table, not an integer");
  EXPECT_EQ(message(R"({"bounds": {"factor": 0}})"),
            "s.toml:1: 'factor' of 'bounds' of optimizer 'toy' is 0; allowed: factor ≥ 1");
}

}  // namespace
}  // namespace nodal
