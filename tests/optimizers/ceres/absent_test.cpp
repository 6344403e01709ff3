// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nodal/registry.h>

namespace nodal {

void register_ceres(Registry& registry);

namespace {

TEST(ABuildWithoutCeres, SaysHowToGetIt) {
  Registry registry;
  register_ceres(registry);
  EXPECT_TRUE(registry.optimizers().empty());
  const AbsentDescription* absent = registry.find_absent("ceres-dogleg");
  ASSERT_NE(absent, nullptr);
  EXPECT_NE(absent->reason.find("libceres-dev"), std::string::npos);
  EXPECT_NE(absent->reason.find("-DNODAL_CERES=ON"), std::string::npos);
}

}  // namespace
}  // namespace nodal
