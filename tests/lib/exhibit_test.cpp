// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/exhibit.h>

#include <gtest/gtest.h>

#include <limits>

#include "toy.h"

namespace nodal {
namespace {

TEST(PlainExhibit, ShowsCostAndQualityOfCoordinates) {
  const toy::ToyProblem problem(2);
  const std::shared_ptr<const Exhibit> exhibit = exhibit_of(problem);
  EXPECT_EQ(exhibit->start(), (std::vector<double>{-1.5, -1.5}));
  const std::vector<double> x = {0.25, 1.5};  // 1 off in the second
  EXPECT_EQ(exhibit->values(x), x);
  const std::unique_ptr<ShownSystem> shown = exhibit->show("bowl", x);
  EXPECT_EQ(shown->failure(), "");
  EXPECT_EQ(to_json(shown->data()), R"({"problem":"bowl","cost":0.5,"quality":1.0})");
  EXPECT_EQ(shown->text(), "bowl: 2 coordinates\nat the start: quality 1, cost 0.5\n");
  ASSERT_EQ(exhibit->formats().size(), 1u);
  EXPECT_EQ(exhibit->write(exhibit->formats()[0], x), R"({"x0":0.25,"x1":1.5})");
}

TEST(PlainExhibit, HasNeitherPictureNorFilesNorPartsToLeaveOut) {
  const toy::ToyProblem problem;
  const std::shared_ptr<const Exhibit> exhibit = exhibit_of(problem);
  EXPECT_FALSE(exhibit->draws());
  EXPECT_FALSE(exhibit->reduces());
  EXPECT_TRUE(exhibit->report("bowl", {}).empty());
  EXPECT_THROW((void)exhibit->read("x.json"), Refusal);
}

}  // namespace
}  // namespace nodal
