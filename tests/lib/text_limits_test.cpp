// SPDX-License-Identifier: GPL-3.0-or-later
// What texts may hold, and what messages quote of them.
#include <gtest/gtest.h>

#include <chrono>

#include <nodal/random.h>
#include <nodal/shown.h>
#include <nodal/toml.h>

#include "../support/messages.h"

namespace nodal {
namespace {

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

std::string toml_refusal(const std::string& text) {
  return toy::message_of([&] { (void)parse_toml(text, "s.toml"); });
}

// ── what messages quote

TEST(Shown, QuotesShortTextsAsTheyAre) {
  EXPECT_EQ(shown(""), "");
  EXPECT_EQ(shown("plate ν = ⅓"), "plate ν = ⅓");
  EXPECT_EQ(shown(std::string(60, 'a')), std::string(60, 'a'));
}

TEST(Shown, CutsLongTextsBetweenCharacters) {
  EXPECT_EQ(shown(std::string(10'000'000, 'a')), std::string(60, 'a') + "…");
  EXPECT_EQ(shown(repeated("ν", 31)), repeated("ν", 30) + "…");
  EXPECT_EQ(shown("a" + repeated("ν", 31)), "a" + repeated("ν", 29) + "…");
  EXPECT_EQ(shown("abcdef", 3), "abc…");
}

TEST(Shown, KeepsControlSequencesAndBytesFromTheTerminal) {
  EXPECT_EQ(shown("a\x1B[31m\r\n"), "a\\u001b[31m\\r\\n");
  EXPECT_EQ(shown(std::string_view("\0x\x7F", 3)), "\\u0000x\\u007f");
  EXPECT_EQ(shown("\xC2\x9B\xC2\xA0"), "\\u009b\xC2\xA0");  // U+009B begins a control sequence; U+00A0 is a space
  EXPECT_EQ(shown("\xFF\xFEn"), "\\xFF\\xFEn");
}

TEST(Beginning, IsTheTextOrWholeCharactersOfIt) {
  EXPECT_EQ(beginning("caf\xE9\x1B", 5), "caf\xE9\x1B");  // as it is
  EXPECT_EQ(beginning("abcdef", 3), "abc…");
  EXPECT_EQ(beginning("aνν", 4), "aν…");
  EXPECT_EQ(beginning("\xE9\xE9\xE9", 2), "\xE9\xE9…");
  EXPECT_EQ(beginning("ν", 1), "…");
}

TEST(Messages, QuoteLittleOfALongName) {
  const std::vector<std::string> valid = {"young", "poisson"};
  EXPECT_LT(name_hint(std::string(1'000'000, 'y'), valid).size(), 100u);
  EXPECT_LT(toml_refusal("x = " + std::string(1'000'000, '1') + "\n").size(), 400u);
  EXPECT_LT(toml_refusal("x = 1\n" + std::string(1'000'000, 'y') + " + 1\n").size(), 400u);
  const auto json = [](const std::string& text) { return toy::message_of([&] { (void)parse_json(text, "f.json"); }); };
  const std::string key = "\"" + std::string(1'000'000, 'k') + "\":1";
  EXPECT_LT(json("{" + key + "," + key + "}").size(), 150u);
  EXPECT_LT(json("[" + std::string(1'000'000, '1') + "]").size(), 150u);
  EXPECT_LT(json("[\"" + std::string(1'000'000, 'a') + "\n\"]").size(), 400u);
}

// ── TOML

TEST(TomlDepth, IsRefusedWithItsLineInEveryForm) {
  const std::string dots = repeated("a.", 10'000) + "a";
  const std::string refused = ": more than 200 tables within each other: brackets within each other, or dots in a key";
  EXPECT_EQ(toml_refusal("x = 1\n" + dots + " = 1\n"), "s.toml:2" + refused);
  EXPECT_EQ(toml_refusal("[" + dots + "]\n"), "s.toml:1" + refused);
  EXPECT_EQ(toml_refusal("\n[[" + dots + "]]\n"), "s.toml:2" + refused);
  EXPECT_EQ(toml_refusal("[problem]\n\noptions." + dots + " = 1\n"), "s.toml:3" + refused);
  EXPECT_EQ(toml_refusal(repeated("\"a\" . ", 10'000) + "a = 1\n"), "s.toml:1" + refused);
  EXPECT_EQ(toml_refusal("x = [1,\n { " + dots + " = 1 }]\n"), "s.toml:2" + refused);
  // What stands in front of it doesn't hide it.
  EXPECT_EQ(toml_refusal("x = \"\"\"a\"\"\"\"\" # \"\n" + dots + " = 1\n"), "s.toml:2" + refused);
  EXPECT_EQ(toml_refusal("x = {y = \"\"\"a\\\"\"\"\"\", " + dots + " = 1}\n"), "s.toml:1" + refused);
  EXPECT_EQ(toml_refusal("x = '\\'\ny = \"\\\"\"\n" + dots + " = 1\n"), "s.toml:3" + refused);
}

// Neither headers, nor brackets, nor dots are too many alone; a table in a table in a table is.
TEST(TomlDepth, CountsAllThatStandWithinEachOther) {
  const std::string header = "[" + repeated("h.", 80) + "h]\n", key = repeated("k.", 80) + "k";
  EXPECT_EQ(toml_refusal(header + key + " = 1\n"), "(nothing was thrown)");
  EXPECT_NE(toml_refusal(header + key + " = { " + key + " = 1 }\n"), "(nothing was thrown)");
  EXPECT_EQ(toml_refusal(header + "x = 1\n[i]\n" + key + " = { " + key + " = 1 }\n"), "(nothing was thrown)");
  std::string nested = "1";
  for (int i = 0; i < 21; ++i) nested = "{ " + repeated("k.", 9) + "k = " + nested + " }";
  EXPECT_NE(toml_refusal("x = " + nested + "\n"), "(nothing was thrown)");
}

TEST(TomlDepth, IsNotTakenFromNumbersTextsAndComments) {
  std::string text = "# " + repeated("a.", 1000) + "\nx = \"" + repeated("a.", 1000) + "\"\ny = '" +
                     repeated("a.", 1000) + "'\nz = \"\"\"\n" + repeated("[a.", 1000) + "\"\"\"\nlist = [";
  text += repeated("1.5, ", 1000) + "]\npoints = [" + repeated("[0.5, 1.5],\n", 1000) + "]\n";
  EXPECT_EQ(parse_toml(text, "s.toml").at("list").list().size(), 1000u);
}

TEST(TomlSize, IsRefusedBeforeItIsParsed) {
  EXPECT_EQ(toml_refusal("x = [" + repeated("1,", 6'000'000) + "]\n"),
            "s.toml: a TOML text of 12 MB; it may have 8 MB: long tables belong into files of their own");
}

// ── tables of many keys

// Each key against each would take 10⁵²/2 comparisons, some 10 s.
TEST(ManyKeys, AreReadAndComparedInTimeThatGrowsLikeTheirNumber) {
  std::string text = "{";
  for (int i = 0; i < 100'000; ++i) text += "\"key" + std::to_string(i) + "\":1,";
  const auto start = std::chrono::steady_clock::now();
  const Value table = parse_json(text + "\"last\":2}", "f.json");
  EXPECT_EQ(table.at("last").integer(), 2);
  EXPECT_TRUE(table == Value(table));
  EXPECT_EQ(toy::message_of([&] { (void)parse_json(text + "\"key77\":2}", "f.json"); }),
            "f.json:1: key 'key77' stands twice");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

}  // namespace
}  // namespace nodal
