// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/value.h>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <nodal/random.h>

#include "../support/messages.h"

namespace nodal {
namespace {

using toy::message_of;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string refusal(std::string_view text) {
  return message_of([&] { (void)parse_json(text, "f.json"); });
}

void expect_same_bits(double number) {
  const std::string text = to_json(Value(number));
  const Value back = parse_json(text, "f.json");
  ASSERT_FALSE(back.is_integer()) << text;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(back.number()), std::bit_cast<std::uint64_t>(number)) << text;
}

TEST(Value, IsAnEmptyTableAtFirst) {
  const Value value;
  EXPECT_TRUE(value.is_table());
  EXPECT_TRUE(value.table().empty());
}

TEST(Value, TellsWhatWasReadAsSomethingElse) {
  const auto message = [](auto action) { return message_of<std::logic_error>(action); };
  EXPECT_EQ(message([] { (void)Value(1).text(); }), "a value was read as a text, but is an integer");
  EXPECT_EQ(message([] { (void)Value(1.5).integer(); }), "a value was read as an integer, but is a number");
  EXPECT_EQ(message([] { (void)Value("x").number(); }), "a value was read as a number, but is a text");
  EXPECT_EQ(message([] { (void)Value(true).list(); }), "a value was read as a list, but is a boolean");
  EXPECT_EQ(message([] { (void)Value(Value::List{}).table(); }), "a value was read as a table, but is a list");
  EXPECT_EQ(message([] { (void)Value().boolean(); }), "a value was read as a boolean, but is a table");
  EXPECT_EQ(message([] { (void)Value().at("k"); }), "a table has no entry 'k'");
  EXPECT_EQ(message([] {
              (void)Value(Value::List{Value(1), Value("x")}).numbers();
            }),
            "a value was read as a number, but is a text");
}

TEST(Value, TakesAnIntegerForANumber) {
  EXPECT_TRUE(Value(3).is_number());
  EXPECT_EQ(Value(3).number(), 3.0);
  EXPECT_EQ(Value(3), Value(3.0));
  EXPECT_NE(Value(3), Value(3.5));
  EXPECT_NE(Value(1), Value(true));
  EXPECT_NE(Value(1), Value("1"));
}

TEST(Value, KeepsTheOrderOfItsKeysAndReplacesInPlace) {
  Value table;
  table.set("b", 1);
  table.set("a", 2);
  table.set("b", 3);
  EXPECT_EQ(to_json(table), R"({"b":3,"a":2})");
}

TEST(Value, IsEqualWhateverTheOrderOfItsKeysAndItsSource) {
  Value a = parse_json(R"({"x": 1, "y": [1, 2]})", "a"), b = parse_json("{\"y\": [1.0, 2],\n\"x\": 1}", "b");
  EXPECT_EQ(a, b);
  b.set("z", 1);
  EXPECT_NE(a, b);
  a.set("w", 1);
  EXPECT_NE(a, b);
}

TEST(Json, WritesTheFewestDigits) {
  EXPECT_EQ(to_json(0.1), "0.1");
  EXPECT_EQ(to_json(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(to_json(1.0), "1.0");
  EXPECT_EQ(to_json(1), "1");
  EXPECT_EQ(to_json(-0.0), "-0.0");
  EXPECT_EQ(to_json(1e100), "1e+100");
  EXPECT_EQ(to_json(5e-324), "5e-324");
  EXPECT_EQ(to_json(std::numeric_limits<double>::max()), "1.7976931348623157e+308");
}

TEST(Json, KeepsEveryBitOfADouble) {
  for (const double number :
       {0.0, -0.0, 0.1, 1.0 / 3.0, 5e-324, -5e-324, 2.2250738585072009e-308, 2.2250738585072014e-308, 1e22, 1e23,
        9007199254740993.0, 123456789012345678.0, 0x1p63, 0x1.fffffffffffffp1023})
    expect_same_bits(number);
  RandomStream random(1);
  for (int i = 0; i < 20000; ++i) {
    const double number = std::bit_cast<double>(random());
    if (std::isfinite(number)) expect_same_bits(number);
  }
}

TEST(Json, KeepsEveryInteger) {
  constexpr std::int64_t k2To53 = std::int64_t{1} << 53;
  for (const std::int64_t number :
       {std::int64_t{0}, k2To53 - 1, k2To53, k2To53 + 1, -k2To53 - 1, std::numeric_limits<std::int64_t>::max(),
        std::numeric_limits<std::int64_t>::min()}) {
    const Value back = parse_json(to_json(Value(number)), "f.json");
    ASSERT_TRUE(back.is_integer());
    EXPECT_EQ(back.integer(), number);
  }
}

TEST(Json, TakesAnIntegerBeyond64BitsForANumber) {
  const Value value = parse_json("[18446744073709551615, 100000000000000000000, -9223372036854775809]", "f.json");
  for (const Value& item : value.list()) EXPECT_FALSE(item.is_integer());
  EXPECT_EQ(value.numbers(), (std::vector<double>{0x1p64, 1e20, -0x1p63}));
}

TEST(Json, NeverHoldsNanOrInfinity) {
  for (const double bad : {std::nan(""), kInfinity, -kInfinity}) {
    Value deep;
    deep.set("list", Value::List{Value(1), Value(bad)});
    EXPECT_THROW((void)to_json(Value(bad)), std::logic_error);
    EXPECT_THROW((void)to_json(deep), std::logic_error);
    EXPECT_THROW((void)to_canonical_json(deep), std::logic_error);
  }
  EXPECT_EQ(refusal("{\n\"a\": 1e999}"), "f.json:2: number '1e999' is too large");
  EXPECT_EQ(refusal("[-1e999]"), "f.json:1: number '-1e999' is too large");
  for (const char* text : {"NaN", "Infinity", "-Infinity", "[nan]", "[inf]"})
    EXPECT_TRUE(refusal(text).starts_with("f.json:1: not valid JSON: ")) << text;
}

TEST(Json, RefusesAKeyThatStandsTwice) {
  EXPECT_EQ(refusal("{\"a\": 1,\n \"b\": 2,\n \"a\": 3}"), "f.json:3: key 'a' stands twice");
  EXPECT_EQ(refusal(R"({"t": {"a": 1, "a": 1}})"), "f.json:1: key 'a' stands twice");
  EXPECT_EQ(parse_json(R"({"a": {"a": 1}, "b": {"a": 1}})", "f.json").table().size(), 2u);
}

TEST(Json, RefusesNull) {
  EXPECT_EQ(refusal("{\"a\": 1,\n\"b\":\nnull}"), "f.json:3: null is not a value here; leave the key out instead");
  EXPECT_EQ(refusal("[1,\nnull]"), "f.json:2: null is not a value in a list; leave it out or give one");
  EXPECT_EQ(refusal("null"), "f.json:1: null is not a value here");
}

TEST(Json, LeavesNullKeysOutWhereAsked) {
  const auto read = [](std::string_view text) { return parse_json(text, "f.json", JsonNull::left_out); };
  EXPECT_EQ(read(R"({"a": null, "b": {"c": null, "d": 1}, "e": null})"), read(R"({"b": {"d": 1}})"));
  for (const char* text : {"[null]", R"({"a": [1, null]})"})
    EXPECT_EQ(message_of([&] { (void)read(text); }),
              "f.json:1: null is not a value in a list; leave it out or give one");
  EXPECT_EQ(message_of([&] { (void)read("null"); }), "f.json:1: null is not a value here");
}

TEST(Json, NamesTheLineOfWhatIsMalformed) {
  const std::pair<const char*, int> texts[] = {
      {"", 1},       {"{", 1},           {"[1,\n2,\n]", 3},    {"{\"a\" 1}", 1}, {"[1]\n[2]", 2},      {"[01]", 1},
      {"[1.]", 1},   {"'a'", 1},         {"[\n\"\\x\"]", 2},   {"\"a\nb\"", 1},  {"[true,\nfals]", 2}, {"// c", 1},
      {"{1: 2}", 1}, {"\"\\ud800\"", 1}, {"[\n\n\"\xff\"]", 3}};
  for (const auto& [text, line] : texts) {
    const std::string message = refusal(text);
    EXPECT_TRUE(message.starts_with("f.json:" + std::to_string(line) + ": not valid JSON: "))
        << text << " → " << message;
    EXPECT_EQ(message.find("json.exception"), std::string::npos) << message;
  }
}

TEST(Json, RefusesAnAttackOnTheStack) {
  const auto nested = [](int depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_NO_THROW((void)parse_json(nested(200), "f.json"));
  EXPECT_EQ(refusal(nested(201)), "f.json:1: more than 200 nested brackets");
  EXPECT_EQ(refusal(std::string(1000000, '[')), "f.json:1: more than 200 nested brackets");
}

TEST(Json, KeepsEveryCharacter) {
  std::string text = "\"\\/ \b\f\n\r\t\x7f äß€😀 ∂u/∂x \xEF\xBF\xBD";
  for (char c = 0; c < 0x20; ++c) text += c;  // NUL as well
  const std::string json = to_json(Value(text));
  for (const char c : json) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
  EXPECT_EQ(parse_json(json, "f.json").text(), text);
  EXPECT_EQ(to_json(Value("\x01\x1f\n")), R"("\u0001\u001f\n")");
  EXPECT_EQ(parse_json(R"("\u00e4\ud83d\ude00\u0000")", "f.json").text(), std::string("ä😀\0", 7));
}

TEST(Json, KeepsAwkwardKeys) {
  Value table;
  for (const char* key : {"", " ", "ä", "a.b", "\"", "\n"}) table.set(key, 1);
  EXPECT_EQ(parse_json(to_json(table), "f.json"), table);
}

// A reason may come from a library in any encoding; a record must not be lost over it.
TEST(Json, ReplacesWhatIsNoUtf8) {
  const std::string mark = "\xEF\xBF\xBD";
  const std::pair<std::string, std::string> texts[] = {
      {"caf\xE9", "caf" + mark},  // Latin-1
      {"\xC3", mark},             // cut off
      {"\xE2\x82", mark + mark},  // cut off
      {"\xF0\x9F\x98 x", mark + mark + mark + " x"},
      {"\xC0\xAF", mark + mark},  // too long a form
      {"\xE0\x80\xAF", mark + mark + mark},
      {"\xF0\x80\x80\xAF", mark + mark + mark + mark},
      {"\xED\xA0\x80", mark + mark + mark},             // half of a surrogate pair
      {"\xF4\x90\x80\x80", mark + mark + mark + mark},  // beyond U+10FFFF
      {"\x80"
       "a\xFE\xFF",
       mark + "a" + mark + mark},
      {"\xC3\xC3\xA4", mark + "ä"},                                                              // what follows stays
      {"\xED\x9F\xBF\xEE\x80\x80\xF4\x8F\xBF\xBF", "\xED\x9F\xBF\xEE\x80\x80\xF4\x8F\xBF\xBF"},  // the valid neighbours
  };
  for (const auto& [text, expected] : texts) {
    EXPECT_EQ(parse_json(to_json(Value(text)), "f.json").text(), expected);
    Value table;
    table.set(text, 1);
    EXPECT_EQ(parse_json(to_canonical_json(table), "f.json").table()[0].first, expected);
  }
}

TEST(Json, ReadsBackWhateverBytesATextHolds) {
  RandomStream random(2);
  for (int i = 0; i < 5000; ++i) {
    std::string text(random.index(12), '\0');
    for (char& c : text) c = static_cast<char>(random.index(4) == 0 ? random.index(128) : 128 + random.index(128));
    const std::string once = parse_json(to_json(Value(text)), "f.json").text();
    EXPECT_EQ(parse_json(to_json(Value(once)), "f.json").text(), once);
  }
}

TEST(Json, KnowsTheLineOfEveryValue) {
  const Value value = parse_json("{\n\"a\": 1\n,\n\"b\": [\n2,\n\"x\"],\n\"c\": true}", "f.json");
  EXPECT_EQ(value.source.text(), "f.json:1");
  EXPECT_EQ(value.at("a").source.text(), "f.json:2");
  EXPECT_EQ(value.at("b").source.text(), "f.json:4");
  EXPECT_EQ(value.at("b").list()[0].source.text(), "f.json:5");
  EXPECT_EQ(value.at("b").list()[1].source.text(), "f.json:6");
  EXPECT_EQ(value.at("c").source.text(), "f.json:7");
}

TEST(CanonicalJson, SortsTheKeysOfEveryTable) {
  const Value a = parse_json(R"({"b": 1, "a": [{"z": 1, "y": 2}], "B": 2})", "a");
  const Value b = parse_json(R"({"B": 2, "a": [{"y": 2, "z": 1}], "b": 1})", "b");
  EXPECT_EQ(to_canonical_json(a), R"({"B":2,"a":[{"y":2,"z":1}],"b":1})");
  EXPECT_EQ(to_canonical_json(a), to_canonical_json(b));
  EXPECT_NE(to_json(a), to_json(b));
}

// Lists keep their order; 1 and 1.0 are of different types, which a schema settles before anything is hashed.
TEST(CanonicalJson, TellsListsAndTypesApart) {
  EXPECT_NE(to_canonical_json(parse_json("[1, 2]", "a")), to_canonical_json(parse_json("[2, 1]", "b")));
  EXPECT_NE(to_canonical_json(Value(1)), to_canonical_json(Value(1.0)));
}

Value random_value(RandomStream& random, int depth) {
  switch (random.index(depth > 0 ? 6 : 4)) {
    case 0:
      return Value(random.index(2) == 0);
    case 1:
      return Value(static_cast<std::int64_t>(random()));
    case 2:
      return Value(random.uniform(-1e3, 1e3));
    case 3:
      return Value(std::string(random.index(4), static_cast<char>(1 + random.index(127))));
    case 4: {
      Value::List list;
      for (std::size_t i = random.index(4); i > 0; --i) list.push_back(random_value(random, depth - 1));
      return Value(list);
    }
    default: {
      Value table;
      for (std::size_t i = random.index(4); i > 0; --i)
        table.set("k" + std::to_string(random.index(9)), random_value(random, depth - 1));
      return table;
    }
  }
}

TEST(Json, SurvivesTheRoundTripWithItsOrder) {
  RandomStream random(3);
  for (int i = 0; i < 2000; ++i) {
    const Value value = random_value(random, 4);
    const std::string text = to_json(value);
    const Value back = parse_json(text, "f.json");
    ASSERT_EQ(back, value) << text;
    ASSERT_EQ(to_json(back), text);
    ASSERT_EQ(to_canonical_json(parse_json(to_canonical_json(value), "f.json")), to_canonical_json(value));
  }
}

TEST(Json, RefusesDamagedTextsPolitely) {
  RandomStream random(4);
  Value whole;
  whole.set("a", random_value(random, 4));
  whole.set("list", Value::List{Value(1.5), Value("ä\n"), Value(true), Value()});
  const std::string text = to_json(whole);
  for (std::size_t cut = 0; cut < text.size(); ++cut) EXPECT_NE(refusal(text.substr(0, cut)), "(nothing was thrown)");
  for (int i = 0; i < 5000; ++i) {
    std::string damaged = text;
    for (int change = 0; change < 3; ++change)
      damaged[random.index(damaged.size())] = static_cast<char>(random.index(256));
    const std::string message = refusal(damaged);  // anything but an InputError would come out here
    EXPECT_TRUE(message == "(nothing was thrown)" || message.starts_with("f.json:")) << message;
  }
}

TEST(ValueTable, GivesWhatIsThereAndOfTheType) {
  const Value table = parse_json(R"({"text": "a", "number": 2, "flag": true})", "t");
  EXPECT_EQ(table.text_or("text", "b"), "a");
  EXPECT_EQ(table.text_or("number", "b"), "b");
  EXPECT_EQ(table.text_or("none", "b"), "b");
  EXPECT_EQ(table.number_or("number", 0.5), 2.0);
  EXPECT_EQ(table.number_or("flag", 0.5), 0.5);
  EXPECT_EQ(table.number_or("none", 0.5), 0.5);
  EXPECT_TRUE(table.flag_or("flag", false));
  EXPECT_FALSE(table.flag_or("text", false));
  EXPECT_TRUE(table.flag_or("none", true));
}

}  // namespace
}  // namespace nodal
