// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/panels.h"
#include "show/stress_panels.h"

#include <gtest/gtest.h>

#include "pictures.h"

namespace nodal::elastic::show {
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
  const Picture plate = fixture::make_square("start", 0.5);
  const Frame frame = make_frame({&plate});
  // 15 % of the plate's 1 m over the largest displacement of 0.1 m is 1.5, so 1.
  EXPECT_DOUBLE_EQ(frame.magnification, 1.0);
  const Point at_rest = frame.at({1.0, 0.0}, {0.0, 0.0}), moved = frame.at({1.0, 0.0}, {0.1, 0.0});
  EXPECT_NEAR((moved[0] - at_rest[0]) / frame.unit, 0.1, 1e-12);  // rounding of one multiplication and one division
  EXPECT_DOUBLE_EQ(moved[1], at_rest[1]);
  EXPECT_GT(frame.at({0.0, 0.0}, {0.0, 0.0})[1], frame.at({0.0, 1.0}, {0.0, 0.0})[1]);  // y points up
}

TEST(PlateSvg, ColoursByTheLogarithmOfStiffness) {
  Picture plate = fixture::make_square("start", 0.5);
  plate.springs = {{0, 1, 1e-2}, {2, 3, 1.0}, {0, 2, 1e2}};
  const StiffnessColours colours({&plate});
  EXPECT_EQ(colours.step(1e-2), 0u);
  EXPECT_EQ(colours.step(1.0), StiffnessColours::kSteps / 2);
  EXPECT_EQ(colours.step(1e2), StiffnessColours::kSteps - 1);
  EXPECT_EQ(StiffnessColours::colour(0), "#440154");
  EXPECT_EQ(StiffnessColours::colour(StiffnessColours::kSteps - 1), "#becd1e");
}

TEST(PlateSvg, OneStiffnessForAllIsOneColour) {
  Picture plate = fixture::make_square("start", 0.5);
  for (PicturedSpring& s : plate.springs) s.stiffness = 0.25;
  EXPECT_EQ(StiffnessColours({&plate}).step(0.25), 0u);
}

TEST(PlateSvg, DrawsSpringsBodyForcesAndSupports) {
  Picture plate = fixture::make_square("start", 0.5);
  plate.columns = 2;
  const Frame frame = make_frame({&plate});
  // 1.1 m wide with displacements, 12 % of that for the arrow, in 240 units less a margin of 5 on each side.
  EXPECT_NEAR(frame.unit, 230.0 / 1.232, 1e-9);
  EXPECT_EQ(
      load_svg(plate, plate.loads[0], frame, StiffnessColours({&plate})),
      R"(<svg class="plate load" viewBox="0 0 240 197" role="img" aria-label="stretch-x, start"><g class="springs" stroke-width="1.60">)"
      R"(<path stroke="#440154" d="M5.0 191.7L210.4 5.0"/>)"
      R"(<path stroke="#4cbc6c" d="M5.0 191.7L210.4 191.7M5.0 5.0L210.4 5.0"/>)"
      R"(<path stroke="#becd1e" d="M5.0 191.7L5.0 5.0M210.4 191.7L210.4 5.0"/></g>)"
      R"(<path class="body" stroke-width="1.20" d="M5.0 191.7L206.6 191.7M5.0 5.0L206.6 5.0M5.0 191.7L5.0 5.0M206.6 191.7L206.6 5.0"/>)"
      R"(<path class="force" d="M210.4 191.7L235.0 191.7M231.0 189.3L235.0 191.7L231.0 194.1M210.4 5.0L235.0 5.0M231.0 2.6L235.0 5.0L231.0 7.4"/>)"
      R"(<rect class="held" x="2.5" y="189.2" width="5.0" height="5.0"/>)"
      R"(<rect class="held" x="2.5" y="2.5" width="5.0" height="5.0"/>)"
      R"(</svg>)");
}

// Two triangles and two cells: bands of 1 MPa up to what 99 % are below, the highest with its plus; the colour of a
// value is that of its band on the scale, whoever has it.
TEST(StressPanels, ShowBodyAndNetOnOneScale) {
  Picture plate = fixture::make_square("start", 0.5);
  EXPECT_EQ(stress_panels(plate, 500.0).height, 0.0);
  plate.rings = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  plate.shares = {{{{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}}, {}, {}, {{{0.5, 0.5}, {1, 0.5}, {1, 1}, {0.5, 1}}}};
  plate.stresses = {{"pull & push", plate.rings[0], {{0, 1, 2}, {0, 2, 3}}, {2.5e6, 9.5e6}, {2.1e6, 0.0, 0.0, 10e6}}};
  const Drawing drawn = stress_panels(plate, 500.0);
  EXPECT_GT(drawn.height, 200.0);
  const auto count = [&](const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = drawn.text.find(part); at != std::string::npos; at = drawn.text.find(part, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count("Von Mises stress [MPa]: pull &amp; push"), 1u);
  EXPECT_EQ(count("body, by finite elements: up to 9.50 MPa"), 1u);
  EXPECT_EQ(count("springs, by node: up to 10.0 MPa"), 1u);
  EXPECT_EQ(count("<rect"), 10u);
  EXPECT_EQ(count("fill:#fec187"), 2u);  // from 2 to 3 MPa: a triangle and a cell
  EXPECT_EQ(count("fill:#3d1069"), 2u);  // from 9 to 10 MPa
  EXPECT_EQ(count("fill:#"), 4u);
  EXPECT_EQ(count("+</text>"), 0u);
  plate.stresses[0].triangles.resize(kMostStressTriangles + 1, {0, 1, 2});
  EXPECT_NE(stress_panels(plate, 500.0).text.find("Stresses of 1 more load are left out."), std::string::npos);
}

}  // namespace
}  // namespace nodal::elastic::show
