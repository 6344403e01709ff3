// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/memory_need.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "../../../support/messages.h"
#include "../../../support/temporary_directory.h"
#include "../block.h"
#include "../plate.h"

namespace nodal::elastic {
namespace {

// The largest resident sizes of `nodal explain` for crossed grids of n × n nodes, measured [bytes].
TEST(MemoryNeed, IsNearWhatWasMeasured) {
  const struct {
    std::size_t side, groups;
    double measured;
  } rows[] = {{100, 4, 174e6}, {200, 4, 748e6}, {300, 4, 1854e6}, {100, 1, 72e6}, {200, 1, 282e6}};
  for (const auto& row : rows) {
    const double ratio = memory_need(row.side * row.side, row.groups) / row.measured;
    EXPECT_GT(ratio, 0.75) << row.side;
    EXPECT_LT(ratio, 1.25) << row.side;
  }
}

// The same for crossed cubes of n × n × n nodes, under `face` and `minimal` supports.
TEST(MemoryNeed, IsNearWhatWasMeasuredInSpace) {
  const struct {
    std::size_t side, groups;
    double measured;
  } rows[] = {{10, 6, 119e6}, {16, 6, 825e6}, {20, 6, 2258e6}, {10, 1, 39.6e6}, {16, 1, 231e6}, {20, 1, 493e6}};
  for (const auto& row : rows) {
    const double ratio = memory_need(row.side * row.side * row.side, row.groups, 3) / row.measured;
    EXPECT_GT(ratio, 0.75) << row.side;
    EXPECT_LT(ratio, 1.25) << row.side;
  }
}

TEST(MemoryNeed, IsRefusedWithItsSize) {
  const Source source{"s.toml", 4};
  EXPECT_EQ(
      toy::message_of([&] { require_memory(1'000'000, 4, 3e10, source); }),
      "s.toml:4: 1000000 nodes under 4 groups of supports need about 24 GB of memory, more than three quarters of "
      "the 30 GB that there are; take fewer nodes");
  EXPECT_EQ(toy::message_of([&] { require_memory(1'000'000, 1, 1.3e10, source); }), "(nothing was thrown)");
  EXPECT_EQ(toy::message_of([&] { require_memory(25, 4, available_memory(), source); }), "(nothing was thrown)");
}

// A process may be given less than the machine has.
class AddressSpace {
 public:
  explicit AddressSpace(rlim_t bytes) {
    ::getrlimit(RLIMIT_AS, &former_);
    const rlimit limit{std::min(bytes, former_.rlim_max), former_.rlim_max};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  ~AddressSpace() { ::setrlimit(RLIMIT_AS, &former_); }
  AddressSpace(const AddressSpace&) = delete;
  AddressSpace& operator=(const AddressSpace&) = delete;

 private:
  rlimit former_{};
};

// The largest grid that may be asked for, at once and not after a minute of filling the memory.
TEST(MemoryNeed, OfTheLargestGridIsRefused) {
  const AddressSpace limit(8'000'000'000);
  const std::string message = toy::message_of([] { (void)make_plate({.counts = "[1000, 1000]"}); });
  EXPECT_TRUE(
      message.starts_with("plate.toml:7: 1000000 nodes need at least 9 GB of memory, "
                          "more than three quarters of the "))
      << message;
  EXPECT_TRUE(
      toy::message_of([] { (void)make_plate({.counts = "[1000, 1001]"}); }).ends_with("more than 1000000 nodes"));
}

// Before a million nodes are joined by eight million springs, which takes seconds: their groups of supports aren't
// known then. What fits under one group only is asked for again when they are.
TEST(MemoryNeed, OfTheLargestBlockIsRefusedBeforeItIsJoined) {
  const AddressSpace limit(8'000'000'000);
  const std::string large =
      toy::message_of([] { (void)make_block({.size = "[1, 1, 1]", .counts = "[100, 100, 100]"}); });
  EXPECT_TRUE(
      large.starts_with("block.toml:5: 1000000 nodes need at least 3.5e+02 GB of memory, more than three "
                        "quarters of the "))
      << large;
  const std::string joined = toy::message_of([] { (void)make_block({.size = "[1, 1, 1]", .counts = "[30, 30, 30]"}); });
  EXPECT_TRUE(joined.starts_with("block.toml:5: 27000 nodes under 6 groups of supports need about ")) << joined;
}

// A load that is fitted as well has a group of its own, whatever is held out.
TEST(MemoryNeed, OfALoadFittedAsWellIsAskedFor) {
  const AddressSpace limit(1'080'000'000);  // of which three quarters are enough for 4 groups, not for 5
  const auto with = [](const std::string& loads) {
    return toy::message_of([&] { (void)make_plate({.supports = "edge\", " + loads, .counts = "[200, 200]"}); });
  };
  EXPECT_EQ(with("held_out = \"none"), "(nothing was thrown)");
  const std::string refused = with("held_out = \"none\", also = \"bend-x");
  EXPECT_NE(refused.find("40000 nodes under 5 groups of supports need about "), std::string::npos) << refused;
}

TEST(MemoryNeed, KnowsTheLimitsOfControlGroups) {
  const toy::TemporaryDirectory folder;
  const auto write = [&](const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder.path() / name).parent_path());
    std::ofstream(folder.path() / name) << text;
  };
  const auto limit = [&] { return control_group_memory(folder.path() / "membership", folder.path() / "groups"); };
  EXPECT_TRUE(std::isinf(limit()));  // no such file
  write("membership", "4:memory:/old\n0::/user.slice/job\n");
  EXPECT_TRUE(std::isinf(limit()));
  write("groups/old/memory.max", "1000\n");  // of version 1: that is another file
  write("groups/user.slice/job/memory.max", "max\n");
  EXPECT_TRUE(std::isinf(limit()));
  write("groups/user.slice/job/memory.max", "2000000000\n");
  EXPECT_EQ(limit(), 2e9);
  write("groups/user.slice/memory.max", "1500000000\n");
  EXPECT_EQ(limit(), 1.5e9);
  write("groups/memory.max", "1400000000\n");  // as a container sees its own
  EXPECT_EQ(limit(), 1.4e9);
  write("membership", "0::/\n");
  EXPECT_EQ(limit(), 1.4e9);
}

}  // namespace
}  // namespace nodal::elastic
