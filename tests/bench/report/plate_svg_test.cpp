// SPDX-License-Identifier: GPL-3.0-or-later
#include <report/plate_svg.h>

#include <gtest/gtest.h>

#include "fixture.h"

namespace nodal::report {
namespace {

TEST(PlateSvg, RoundsTheMagnificationToWhatCanBeSaid) {
  EXPECT_DOUBLE_EQ(round_down_125(1.5), 1.0);
  EXPECT_DOUBLE_EQ(round_down_125(2.0), 2.0);
  EXPECT_DOUBLE_EQ(round_down_125(0.5), 0.5);
  EXPECT_DOUBLE_EQ(round_down_125(4.99), 2.0);
  EXPECT_DOUBLE_EQ(round_down_125(1234.0), 1000.0);
  EXPECT_DOUBLE_EQ(round_down_125(0.00075), 0.0005);
}

TEST(PlateSvg, DrawsDisplacementsAtTheMagnificationItStates) {
  const Plate plate = fixture::make_square("start", 0.5);
  const PlateFrame frame = make_frame({&plate});
  // 15 % of the plate's 1 m over the largest displacement of 0.1 m is 1.5, so 1.
  EXPECT_DOUBLE_EQ(frame.magnification, 1.0);
  const Vector2 at_rest = frame.at({1.0, 0.0}, {0.0, 0.0}), moved = frame.at({1.0, 0.0}, {0.1, 0.0});
  EXPECT_NEAR((moved[0] - at_rest[0]) / frame.unit, 0.1, 1e-12);  // rounding of one multiplication and one division
  EXPECT_DOUBLE_EQ(moved[1], at_rest[1]);
  EXPECT_GT(frame.at({0.0, 0.0}, {0.0, 0.0})[1], frame.at({0.0, 1.0}, {0.0, 0.0})[1]);  // y points up
}

TEST(PlateSvg, ColoursByTheLogarithmOfStiffness) {
  Plate plate = fixture::make_square("start", 0.5);
  plate.springs = {{0, 1, 1e-2}, {2, 3, 1.0}, {0, 2, 1e2}};
  const StiffnessColours colours({&plate});
  EXPECT_EQ(colours.step(1e-2), 0u);
  EXPECT_EQ(colours.step(1.0), StiffnessColours::kSteps / 2);
  EXPECT_EQ(colours.step(1e2), StiffnessColours::kSteps - 1);
  EXPECT_EQ(StiffnessColours::colour(0), "#440154");
  EXPECT_EQ(StiffnessColours::colour(StiffnessColours::kSteps - 1), "#becd1e");
}

TEST(PlateSvg, OneStiffnessForAllIsOneColour) {
  Plate plate = fixture::make_square("start", 0.5);
  for (PlateSpring& s : plate.springs) s.stiffness = 0.25;
  EXPECT_EQ(StiffnessColours({&plate}).step(0.25), 0u);
}

TEST(PlateSvg, DrawsSpringsBodyForcesAndSupports) {
  const Plate plate = fixture::make_square("start", 0.5);
  const PlateFrame frame = make_frame({&plate});
  // 1.1 m wide with displacements, 14 % of that as margin on each side: 240 units for 1.408 m.
  EXPECT_NEAR(frame.unit, 240.0 / 1.408, 1e-9);
  EXPECT_EQ(
      panel_svg(plate, plate.loads[0], frame, StiffnessColours({&plate})),
      R"(<svg viewBox="0 0 240 223" role="img" aria-label="stretch-x, start">)"
      R"(<path stroke="#440154" d="M26.2 196.7L213.8 26.2"/>)"
      R"(<path stroke="#4cbc6c" d="M26.2 196.7L213.8 196.7M26.2 26.2L213.8 26.2"/>)"
      R"(<path stroke="#becd1e" d="M26.2 196.7L26.2 26.2M213.8 196.7L213.8 26.2"/>)"
      R"(<path class="body" d="M26.2 196.7L210.3 196.7M26.2 26.2L210.3 26.2M26.2 196.7L26.2 26.2M210.3 196.7L210.3 26.2"/>)"
      R"(<path class="force" d="M213.8 196.7L236.3 196.7M232.3 194.3L236.3 196.7L232.3 199.1M213.8 26.2L236.3 26.2M232.3 23.8L236.3 26.2L232.3 28.6"/>)"
      R"(<rect class="held" x="23.8" y="194.2" width="5" height="5"/>)"
      R"(<rect class="held" x="23.8" y="23.7" width="5" height="5"/>)"
      R"(</svg>)");
}

}  // namespace
}  // namespace nodal::report
