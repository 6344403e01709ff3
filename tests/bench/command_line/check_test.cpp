// SPDX-License-Identifier: GPL-3.0-or-later
// `nodal check`: every row of the battery, and what becomes of a battery that is wrong.
#include <gtest/gtest.h>

#include <nodal/value.h>

#include "program.h"

namespace nodal::program {
namespace {

constexpr const char* kPair = R"([[case]]
name = "pair"
expect = "EXPECT"
nodes = [[0, 0], [1, 0]]
springs = [[0, 1]]
supports = [[0, 0], [0, 1], [1, 1]]
forces = [[1, 1.0, 0.0]]
)";

std::string pair_expecting(const std::string& status) {
  std::string text = kPair;
  return text.replace(text.find("EXPECT"), 6, status);
}

TEST(Check, FindsEveryRowAsExpected) {
  const Folder folder;
  const Output output = run(folder, {"check", "--json"});
  const Value rows = parse_json(output.out, "stdout");
  EXPECT_GE(rows.list().size(), 40u);
  for (const Value& row : rows.list()) EXPECT_TRUE(row.at("as_expected").boolean()) << to_json(row);
  EXPECT_EQ(output.exit, 0);
}

TEST(Check, PrintsATable) {
  const Folder folder;
  folder.write("mine.toml", pair_expecting("ok"));
  const Output output = run(folder, {"check", "mine.toml"});
  EXPECT_EQ(output.exit, 0) << output.out << output.err;
  EXPECT_TRUE(output.out.starts_with("case ")) << output.out;
  EXPECT_TRUE(contains(output.out, "\n1 cases, 0 not as expected\n")) << output.out;
}

TEST(Check, ExitsWithOneWhenARowDiffers) {
  const Folder folder;
  folder.write("mine.toml", pair_expecting("ill_conditioned"));
  const Output output = run(folder, {"check", "mine.toml"});
  EXPECT_EQ(output.exit, 1);
  EXPECT_TRUE(contains(output.out, "DIFFERS: another status than expected")) << output.out;
}

TEST(Check, RefusesABatteryThatIsWrong) {
  struct Wrong {
    std::string text, message;
  };
  const Wrong all[] = {
      {"x = 1\n", "a battery consists of [[case]] tables and nothing else"},
      {"[[case]]\nname = \"a\"\nexpect = \"ok\"\n", "mine.toml:1: a case needs one of 'problem', 'study' and 'nodes'"},
      {pair_expecting("fine"), "'expect' of case"},
      {pair_expecting("ok") + "stifness = 2.0\n", "did you mean 'stiffness'"},
      {pair_expecting("ok") + "change = [{ springs = \"all\" }]\n", "either 'stiffness' or 'decades'"},
      {pair_expecting("ok") + "change = [1]\n", "a change must be a table"},
      {"[[case]]\nname = \"a\"\nexpect = \"ok\"\nproblem = {}\nsupports = [[0, 0]]\n",
       "mine.toml:5: 'supports' belongs to a net by hand, which has 'nodes'"},
      {"[[case]]\nname = \"a\"\nexpect = \"ok\"\nproblem = {}\nsprings = [[0, 1]]\n",
       "mine.toml:5: 'springs' belongs to a net by hand, which has 'nodes'"},
      {"[[case]]\nname = \"a\"\nexpect = \"ok\"\nnodes = [[0, 0], [1, 0, 0]]\n",
       "'nodes' must be a list of lists of 2 numbers, or of 3 in space"},
  };
  for (const Wrong& wrong : all) {
    const Folder folder;
    folder.write("mine.toml", wrong.text);
    const Output output = run(folder, {"check", "mine.toml"});
    EXPECT_EQ(output.exit, 2) << wrong.text;
    EXPECT_TRUE(contains(output.err, wrong.message)) << output.err;
  }
  EXPECT_EQ(run(Folder(), {"check", "nowhere.toml"}).exit, 2);
}

// What a battery in one case says, per row of the table.
Value only_row(const std::string& text) {
  const Folder folder;
  folder.write("mine.toml", text);
  const Output output = run(folder, {"check", "mine.toml", "--json"});
  EXPECT_NE(output.exit, 2) << output.err;
  return parse_json(output.out, "stdout").list().at(0);
}

// Cubes of 2 × 2 × 2 cells. Stretched by powers of two they are the same numbers for what directions and lengths there
// are; a force along z counts, and nothing of z is lost.
TEST(Check, IsInSpaceWhereTheProblemIs) {
  const std::string cube =
      "[[case]]\nname = \"cube\"\nexpect = \"EXPECT\"\nproblem = { body = { size = [2, 2, 2] }, points = { counts = "
      "[3, 3, 3] } }\nstiffness = 1.0\n";
  const auto with = [&](const std::string& more, const std::string& expect = "ok") {
    std::string text = cube + more;
    return only_row(text.replace(text.find("EXPECT"), 6, expect));
  };
  for (const char* more :
       {"", "stretch = [1.0, 1.0, 1.0]\n", "stretch = [1.0, 4.0, 0.25]\n", "forces = [[26, 0.0, 0.0, 1.0]]\n",
        "change = [{ springs = \"z\", stiffness = 1e6 }, { springs = \"x\", stiffness = 2.0 }]\n",
        "change = [{ springs = \"diagonal\", stiffness = 1e-6 }]\n",
        "change = [{ within = [0, 0, 0, 2, 2, 1], stiffness = 1e3 }]\n"}) {
    const Value row = with(more);
    EXPECT_TRUE(row.at("as_expected").boolean()) << more << to_json(row);
  }
  // No spring along y is diagonal, none of the upper half within the lower: only these grow beyond what is a stiffness.
  EXPECT_PRED2(contains,
               with("change = [{ springs = \"y\", stiffness = nan }]\n", "invalid_input").at("message").text(),
               "spring (0, 3)");
  EXPECT_PRED2(contains,
               with("change = [{ springs = \"z\", stiffness = nan }]\n", "invalid_input").at("message").text(),
               "spring (0, 9)");
  EXPECT_PRED2(contains,
               with("change = [{ springs = \"diagonal\", stiffness = nan }]\n", "invalid_input").at("message").text(),
               "spring (0, 4)");
  EXPECT_PRED2(
      contains,
      with("change = [{ within = [0, 0, 1.5, 2, 2, 2], stiffness = nan }]\n", "invalid_input").at("message").text(),
      "spring (18, 19)");
  const struct {
    const char *more, *message;
  } refused[] = {
      {"stretch = [1.0, 1.0]\n", "'stretch' has 2 entries; a system in space needs 3"},
      {"forces = [[26, 0.0, 1.0]]\n", "an entry of 'forces' has 3 entries; a system in space needs 4"},
      {"change = [{ within = [0, 0, 1, 1], stiffness = 1.0 }]\n", "'within' has 4 entries; a system in space needs 6"},
      {"change = [{ springs = \"horizontal\", stiffness = 1.0 }]\n",
       "springs = \"horizontal\" are of the plane; in space take \"x\", \"y\" or \"z\""},
  };
  for (const auto& [more, message] : refused) {
    const Value row = with(more, "refused");
    EXPECT_TRUE(row.at("as_expected").boolean()) << to_json(row);
    EXPECT_PRED2(contains, row.at("message").text(), message);
  }
}

// Three legs from the ground to a node that a force along z pulls at: the determinate tripod.
TEST(Check, TakesNetsByHandInSpace) {
  const std::string tripod =
      "[[case]]\nname = \"tripod\"\nexpect = \"ok\"\nnodes = [[1, 0, 0], [0, 1, 0], [-1, -1, 0], [0, 0, 1]]\n"
      "springs = [[0, 3], [3, 1], [2, 3]]\nsupports = [[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [1, 2], [2, 0], [2, 1], "
      "[2, 2]]\nforces = [[3, 0.0, 0.0, 1.0]]\n";
  EXPECT_TRUE(only_row(tripod).at("as_expected").boolean()) << to_json(only_row(tripod));
  std::string flat = tripod;  // along z nothing holds it
  flat.replace(flat.find("[0, 0, 1]]"), 10, "[0, 0, 0]]").replace(flat.find("\"ok\""), 4, "\"not_positive_definite\"");
  EXPECT_TRUE(only_row(flat).at("as_expected").boolean()) << to_json(only_row(flat));
  std::string between = tripod + "change = [{ between = [3, 1], stiffness = nan }]\n";
  between.replace(between.find("\"ok\""), 4, "\"invalid_input\"");
  EXPECT_PRED2(contains, only_row(between).at("message").text(), "spring (1, 3)");
}

// Nodes and springs that aren't there are refused like any other bad input: a row that differs, with the reason.
TEST(Check, SaysWhatACaseRefersToInVain) {
  const Folder folder;
  folder.write("mine.toml", pair_expecting("ok") + "change = [{ node = 7, stiffness = 1.0 }]\n");
  const Output output = run(folder, {"check", "mine.toml"});
  EXPECT_EQ(output.exit, 1);
  EXPECT_TRUE(contains(output.out, "a 'change' concerns no spring")) << output.out;
}

}  // namespace
}  // namespace nodal::program
