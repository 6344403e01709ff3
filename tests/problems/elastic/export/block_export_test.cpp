// SPDX-License-Identifier: GPL-3.0-or-later
// A block that is written as JSON and started from again.
#include <gtest/gtest.h>

#include <cmath>

#include <nodal/elastic/stiffness.h>
#include <nodal/random.h>
#include <nodal/value.h>

#include "../block.h"
#include "../study_files.h"

namespace nodal::elastic {
namespace {

class BlockExport : public StudyFiles {
 protected:
  std::shared_ptr<const ElasticProblem> from_file(BlockOptions options) {
    options.initial = "{ file = \"fitted.json\" }";
    return as_elastic(parse_study(block_toml(options), directory_.path() / "study.toml", components()));
  }
};

TEST_F(BlockExport, StartsAgainWithTheSameStiffnesses) {
  const BlockOptions options{.size = "[3, 2, 0.7]", .counts = "[4, 3, 3]"};
  const auto block = make_block(options);
  RandomStream random(2);
  std::vector<double> k(block->net().springs.size());
  for (double& e : k) e = std::exp(random.uniform(-4.0, 4.0));
  write("fitted.json", system_json(*block, k));
  EXPECT_EQ(from_file(options)->start_stiffness(), k);  // to the last bit
}

TEST_F(BlockExport, HasThePlacesOfNodes) {
  const auto block = make_block({.size = "[3, 2, 0.7]", .counts = "[4, 3, 3]"});
  const Value system = parse_json(system_json(*block, block->start_stiffness()), "system");
  const Value::List& nodes = system.at("nodes").list();
  ASSERT_EQ(nodes.size(), 36u);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_EQ(nodes[i].at("x").number(), block->net().nodes[i][0]);
    EXPECT_EQ(nodes[i].at("y").number(), block->net().nodes[i][1]);
    EXPECT_EQ(nodes[i].at("z").number(), block->net().nodes[i][2]);
  }
  EXPECT_EQ(system.at("springs").list().size(), block->net().springs.size());
}

TEST_F(BlockExport, OfAnotherBlockIsRefused) {
  const auto block = make_block({.topology = "single"});
  write("fitted.json", system_json(*block, block->start_stiffness()));
  EXPECT_PRED2(says, toy::message_of([&] { (void)from_file({}); }),
               "is missing; every spring of the net must stand once; a system of its own, as after --prune, is read in "
               "the plane only");
}

// Nodes and springs of boxes have the same names as far as their counts go; a body of another size doesn't fit a file.
TEST_F(BlockExport, OfABlockOfAnotherSizeIsRefused) {
  const auto block = make_block();
  write("fitted.json", system_json(*block, block->start_stiffness()));
  EXPECT_PRED2(says, toy::message_of([&] { (void)from_file({.size = "[4, 4, 7]"}); }),
               "spring (0, 1) has length 1 m in the file and 2 m in the net: the file is of another body or net, or "
               "not in metres; give "
               "stiffnesses that belong to this one");
  EXPECT_PRED2(says, toy::message_of([&] { (void)from_file({.size = "[2, 2, 3]"}); }), " has length 1 m in the file");
  std::string nodes = "{\"nodes\": [{\"x\": 0, \"y\": 0, \"z\": 0}, {\"x\": 1, \"y\": 0, \"z\": 0.5}],\n";
  const std::string whole = system_json(*block, block->start_stiffness());
  write("fitted.json", nodes + whole.substr(whole.find("\"springs\"")));
  EXPECT_PRED2(says, toy::message_of([&] { (void)from_file({}); }),
               "node 1 is at (1, 0, 0.5) m in the file and at (1, 0, 0) m in the net");
}

}  // namespace
}  // namespace nodal::elastic
