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
