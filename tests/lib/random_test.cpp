// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace nodal {
namespace {

// Known answers published with Random123 (Salmon et al., SC11).
TEST(Philox, GivesThePublishedWords) {
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox4x32({~0u, ~0u, ~0u, ~0u}, {~0u, ~0u}), (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomStream, DependsOnItsKeyAlone) {
  RandomStream a(7), b(7), c(8);
  bool differs = false;
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t word = a();
    EXPECT_EQ(word, b());
    differs = differs || word != c();
  }
  EXPECT_TRUE(differs);
}

// 1e5 draws: the mean of U(−2, 4) is 1 with standard deviation √3/√1e5 = 0.0055; five of them.
TEST(RandomStream, IsUniform) {
  RandomStream random(1);
  double sum = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform(-2.0, 4.0);
    ASSERT_GE(x, -2.0);
    ASSERT_LT(x, 4.0);
    sum += x;
  }
  EXPECT_NEAR(sum / 100000, 1.0, 0.028);
}

// χ² with 6 degrees of freedom exceeds 33 with probability 1e-5; the seed is fixed.
TEST(RandomStream, IndexIsUnbiased) {
  RandomStream random(3);
  std::vector<int> counts(7, 0);
  for (int i = 0; i < 70000; ++i) ++counts.at(random.index(7));
  double chi_squared = 0.0;
  for (const int count : counts) chi_squared += std::pow(count - 10000.0, 2) / 10000.0;
  EXPECT_LT(chi_squared, 33.0);
}

// Published vectors of FNV-1a.
TEST(Hash, GivesThePublishedValues) {
  EXPECT_EQ(hash64(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hash64("foobar"), 0x85944171f73967e8u);
  EXPECT_EQ(hash128(""), "6c62272e07bb014262b821756295c58d");
  EXPECT_EQ(hash128("foobar"), "343e1662793c64bf6f0d3597ba446f18");
}

}  // namespace
}  // namespace nodal
