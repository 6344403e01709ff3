// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/account.h>

#include <gtest/gtest.h>

#include "../study_files.h"

namespace nodal::elastic {
namespace {

TEST(Account, KeepsStagesInTheOrderInWhichTheyAreToldOf) {
  Account account;
  account.used("points", "grid");
  account.left_out("masses", "none needed");
  account.used("springs", "72");
  account.used("points", "grid of 5 × 5");         // told anew, in its place
  account.left_out("springs", "nobody left any");  // they were used
  account.used("masses", "after all");
  ASSERT_EQ(account.stages().size(), 3u);
  EXPECT_EQ(account.stages()[0].name + ": " + account.stages()[0].detail, "points: grid of 5 × 5");
  EXPECT_TRUE(account.stages()[1].used);
  EXPECT_EQ(account.detail_of("springs"), "72");
  EXPECT_EQ(account.detail_of("loads"), "");
}

TEST(Account, TellsFindingsAmongTheRemarks) {
  Account account;
  account.remark("mended");
  account.finding("odd");
  EXPECT_EQ(account.remarks(), (std::vector<std::string>{"mended", "odd"}));
  EXPECT_EQ(account.findings(), std::vector<std::string>{"odd"});
}

// What makers say is what people are told: in the order of the work, each stage once, and nothing of it twice.
TEST_F(SmallSystem, StagesOfAStudyAreToldInTheOrderOfTheWork) {
  const auto problem = read("points = { counts = [4, 4] }\n");
  std::vector<std::string> names;
  for (const Stage& stage : problem->stages()) names.push_back(stage.name);
  EXPECT_EQ(names, (std::vector<std::string>{"body",
                                             "material",
                                             "points",
                                             "iterated Voronoi regions",
                                             "springs",
                                             "Delaunay triangulation",
                                             "masses",
                                             "loads",
                                             "analytic reference",
                                             "finite elements",
                                             "measured reference",
                                             "rigidity by sparse QR",
                                             "held-out loads",
                                             "bounds",
                                             "initial stiffness",
                                             "prior",
                                             "parameters",
                                             "lanes",
                                             "equilibrium",
                                             "gradient",
                                             "moves"}));
}

}  // namespace
}  // namespace nodal::elastic
