// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nodal/registry.h>

namespace nodal {

void register_nlopt(Registry& registry);

namespace {

TEST(ABuildWithoutNlopt, SaysHowToGetIt) {
  Registry registry;
  register_nlopt(registry);
  EXPECT_TRUE(registry.optimizers().empty());
  const AbsentDescription* absent = registry.find_absent("nlopt-lbfgs");
  ASSERT_NE(absent, nullptr);
  EXPECT_NE(absent->reason.find("libnlopt-cxx-dev"), std::string::npos);
  EXPECT_NE(absent->reason.find("-DNODAL_NLOPT=ON"), std::string::npos);
}

}  // namespace
}  // namespace nodal
