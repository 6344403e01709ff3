// SPDX-License-Identifier: GPL-3.0-or-later
// What `nodal evaluate` and `nodal explain` tell of a system that a user has brought.
#include <gtest/gtest.h>

#include <nodal/value.h>

#include "program.h"

namespace nodal::program {
namespace {

// Nodes 1 (0, 0), 20 (4, 0), 300 (2, 3); stiffnesses 1e-3, 1 and 10 in bounds of [1e-3, 10].
std::string study(const Folder& folder, const std::string& forces, bool reference) {
  folder.write("nodes.csv", "node,x,y\n1,0,0\n20,4,0\n300,2,3\n");
  folder.write("springs.csv", "first,second,stiffness\n1,20,0.001\n1,300,1\n20,300,10\n");
  folder.write("displacements.csv", "node,ux,uy\n300,0.1,-0.2\n20,0.1,\n");
  return std::string(
             "[problem]\nkind = \"elastic\"\npoints = { file = \"nodes.csv\" }\nsprings = { file = "
             "\"springs.csv\", bounds = [1e-3, 10] }\nmaterial = { young = 1 }\n") +
         (reference ? "reference = { file = \"displacements.csv\" }\n" : "") +
         "[[problem.loads.cases]]\nname = \"push\"\nsupports = [{ nodes = [1] }, { nodes = [20], fix = \"y\" "
         "}]\nforces = [" +
         forces + "]\n";
}

TEST(EvaluateJson, NamesNodesAndCountsBounds) {
  const Folder folder;
  folder.write("s.toml", study(folder, "{ nodes = [300], force = [0, -1] }", true));
  const Output output = run(folder, {"evaluate", "s.toml", "--json"});
  ASSERT_EQ(output.exit, 0) << output.err;
  const Value state = parse_json(output.out, "stdout");
  EXPECT_EQ(to_json(state.at("node_names")), "[1,20,300]");
  EXPECT_EQ(state.at("loads").list()[0].at("displacement").list().size(), 3u);  // one per name
  EXPECT_EQ(to_json(state.at("at_bounds")), R"({"coordinates":3,"lower":1,"upper":1})");
}

// Without a reference nothing is fitted, and no bound decides anything.
TEST(EvaluateJson, WithoutAReferenceHasNamesOnly) {
  const Folder folder;
  folder.write("s.toml", study(folder, "{ nodes = [300], force = [0, -1] }", false));
  const Value state = parse_json(run(folder, {"evaluate", "s.toml", "--json"}).out, "stdout");
  EXPECT_EQ(to_json(state.at("node_names")), "[1,20,300]");
  EXPECT_EQ(state.find("at_bounds"), nullptr);
}

TEST(Evaluate, TellsOfWhatWasNeverFitted) {
  const Folder folder;
  const std::string plate = "[problem]\nkind = \"elastic\"\npoints = { counts = [4, 3] }\n";
  folder.write("s.toml", plate);
  const Value state = parse_json(run(folder, {"evaluate", "s.toml", "--json"}).out, "stdout");
  const Value& unseen = state.at("unseen");
  EXPECT_GT(unseen.at("error").number(), 0.0);
  ASSERT_EQ(unseen.at("loads").list().size(), 2u);
  const Value& bending = unseen.at("loads").list()[0];
  EXPECT_EQ(bending.at("name").text(), "bend-x");
  EXPECT_GT(bending.at("relative_error").number(), 0.0);
  for (const char* by_node : {"displacement", "reference"}) EXPECT_EQ(bending.at(by_node).list().size(), 12u);
  const std::string text = run(folder, {"evaluate", "s.toml"}).out;
  EXPECT_TRUE(contains(text, "(root mean square of 2 loads that are never fitted; worst: bend-")) << text;
  EXPECT_TRUE(contains(text, "\nnever fitted relative error ")) << text;
  EXPECT_TRUE(contains(text, "\nbend-y ")) << text;
  EXPECT_FALSE(contains(text, "explicit integration")) << text;

  folder.write("none.toml",
               "[problem]\nkind = \"elastic\"\npoints = { counts = [5, 4] }\nloads = { held_out = \"none\" }\n"
               "masses = { form = \"least-norm\" }\n");
  const Value heavy = parse_json(run(folder, {"evaluate", "none.toml", "--json"}).out, "stdout");
  EXPECT_EQ(heavy.find("unseen"), nullptr);
  EXPECT_GE(heavy.at("stable_step_estimate").number(), heavy.at("health").at("stable_step").number());
  EXPECT_EQ(state.find("stable_step_estimate"), nullptr);
  const std::string without = run(folder, {"evaluate", "none.toml"}).out;
  EXPECT_FALSE(contains(without, "never fitted") || contains(without, "unseen")) << without;
  EXPECT_TRUE(contains(without, "explicit integration in time is stable below ")) << without;
}

TEST(Evaluate, TellsOfALoadThatMovesNothing) {
  const Folder folder;
  folder.write("s.toml", study(folder, "{ nodes = [1], force = [1, 2] }", false));
  const std::string note = "note: nothing moves in load 'push': what pulls acts only where supports hold";
  const Output evaluated = run(folder, {"evaluate", "s.toml"});
  EXPECT_EQ(evaluated.exit, 0);
  EXPECT_TRUE(contains(evaluated.err, note)) << evaluated.err;
  EXPECT_TRUE(contains(run(folder, {"evaluate", "s.toml", "--json"}).err, note));
  EXPECT_TRUE(contains(run(folder, {"explain", "s.toml"}).out, note));
  folder.write("s.toml", study(folder, "{ nodes = [1], force = [1, 2] }", true));
  for (const char* command : {"evaluate", "explain", "fit", "compare"}) {
    const Output refused = run(folder, {command, "s.toml"});
    EXPECT_EQ(refused.exit, 2) << command;
    EXPECT_TRUE(contains(refused.err, "nothing moves in load 'push'")) << refused.err;
  }
}

}  // namespace
}  // namespace nodal::program
