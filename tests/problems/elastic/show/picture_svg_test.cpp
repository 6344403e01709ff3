// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures against snapshots in tests/data/pictures. Look at what has changed, then renew them:
//     NODAL_RENEW_SNAPSHOTS=1 elastic_show_test --gtest_filter='*Picture*'
#include "show/picture_svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

#include <fmt/format.h>

#include "show/mechanism_svg.h"
#include "show/panels.h"

#include "../../../support/count.h"
#include "pictures.h"
#include "well_formed.h"

namespace nodal::elastic::show {
namespace {

using toy::count;

// The same plate a hair larger: what the last bits of another compiler's figures may do.
Picture scaled(Picture plate, double factor) {
  const auto scale = [&](std::vector<Point>& vectors) {
    for (Point& v : vectors) v = {factor * v[0], factor * v[1]};
  };
  scale(plate.nodes);
  for (Ring& ring : plate.rings) scale(ring);
  for (std::vector<Ring>& rings : plate.cells)
    for (Ring& ring : rings) scale(ring);
  for (PicturedLoad& load : plate.loads)
    for (std::vector<Point>* vectors : {&load.displacement, &load.reference, &load.forces}) scale(*vectors);
  for (double& mass : plate.masses) mass *= factor;
  for (std::size_t e = 0; e < plate.springs.size(); ++e) plate.springs[e].stiffness *= e % 2 == 0 ? factor : 1.0;
  return plate;
}

Mechanism scaled(Mechanism mechanism, double factor) {
  for (std::vector<Point>* vectors : {&mechanism.nodes, &mechanism.motion})
    for (Point& v : *vectors) v = {factor * v[0], factor * v[1]};
  for (Ring& ring : mechanism.rings)
    for (Point& v : ring) v = {factor * v[0], factor * v[1]};
  return mechanism;
}

struct Snapshot {
  const char* name;
  std::function<std::string(double)> draw;  ///< with its figures times a factor
};

void PrintTo(const Snapshot& snapshot, std::ostream* out) { *out << snapshot.name; }

// Empty for equal texts; else where they first differ.
std::string difference(const std::string& drawn, const std::string& expected) {
  const auto [a, b] = std::ranges::mismatch(drawn, expected);
  if (a == drawn.end() && b == expected.end()) return {};
  const auto at = static_cast<std::size_t>(a - drawn.begin());
  const std::size_t from = at - std::min<std::size_t>(at, 40);
  return "drawn: …" + drawn.substr(from, 60) + "… expected: …" + expected.substr(std::min(from, expected.size()), 60) +
         "…";
}

class Pictures : public testing::TestWithParam<Snapshot> {};

TEST_P(Pictures, AreAsTheyWere) {
  const std::string path = std::string(NODAL_TEST_DATA) + "/pictures/" + GetParam().name + ".svg";
  const std::string drawn = GetParam().draw(1.0);
  if (std::getenv("NODAL_RENEW_SNAPSHOTS") != nullptr) {
    std::ofstream(path, std::ios::binary) << drawn;
    GTEST_SKIP() << "renewed: " << path;
  }
  std::ifstream file(path, std::ios::binary);
  std::ostringstream expected;
  expected << file.rdbuf();
  EXPECT_EQ(difference(drawn, expected.str()), "") << path << "; when that is meant, renew it";
}

TEST_P(Pictures, DontHangOnTheLastBits) {
  const std::string drawn = GetParam().draw(1.0);
  EXPECT_EQ(difference(GetParam().draw(1.0 + 1e-13), drawn), "");
  EXPECT_EQ(difference(GetParam().draw(1.0 - 1e-13), drawn), "");
}

TEST_P(Pictures, AreWellFormed) { EXPECT_EQ(fixture::WellFormed(GetParam().draw(1.0)).error(), ""); }

INSTANTIATE_TEST_SUITE_P(
    All, Pictures,
    testing::Values(Snapshot{"grid", [](double f) { return picture_svg(scaled(fixture::make_grid(), f)); }},
                    Snapshot{"disc", [](double f) { return picture_svg(scaled(fixture::make_disc(), f)); }},
                    Snapshot{"strip", [](double f) { return picture_svg(scaled(fixture::make_frame_with_hole(), f)); }},
                    Snapshot{"mechanism",
                             [](double f) { return mechanism_svg(scaled(fixture::make_mechanism(), f)); }}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(PictureSvg, HasTheSystemAndAPanelForEachLoad) {
  const Picture plate = fixture::make_disc();
  const std::string picture = picture_svg(plate);
  EXPECT_EQ(count(picture, "<g class=\"load\""), 3u);
  EXPECT_EQ(count(picture, "<g class=\"springs\""), 4u);
  for (const PicturedLoad& load : plate.loads) EXPECT_EQ(count(picture, ">" + load.name + "</text>"), 1u);
  EXPECT_EQ(count(picture, "relative error 0.05340 · G 0.01732 m · 37 nodes, 90 springs"), 1u);
  EXPECT_EQ(count(picture, "Voronoi"), 1u);
}

TEST(PictureSvg, PutsWhatWasNeverFittedUnderAHeading) {
  Picture plate = fixture::make_disc();
  plate.unseen_error = 0.125;
  plate.loads[2].unseen = 0.25;
  const std::string picture = picture_svg(plate);
  EXPECT_EQ(fixture::WellFormed(picture).error(), "");
  EXPECT_EQ(count(picture, "<g class=\"load\""), 3u);
  const std::size_t heading = picture.find(">Never fitted: unseen error 0.1250 over these loads</text>");
  ASSERT_NE(heading, std::string::npos);
  EXPECT_LT(picture.find(">stretch-y</text>"), heading);
  EXPECT_LT(heading, picture.find(">shear, never fitted</text>"));
  EXPECT_EQ(count(picture, ">relative error 0.2500</text>"), 1u);
  EXPECT_EQ(count(picture_svg(fixture::make_disc()), "ever fitted"), 0u);
}

TEST(PictureSvg, HostileLabelsStayText) {
  Picture plate = fixture::make_square("</title><script>alert(1)</script>&\"'\x01\xEF\xBF\xBE", 0.5);
  plate.loads[0].name = plate.title;
  const std::string picture = picture_svg(plate);
  EXPECT_EQ(fixture::WellFormed(picture).error(), "");
  EXPECT_EQ(count(picture, "<script"), 0u);
  EXPECT_EQ(count(picture, "\xEF\xBF\xBE"), 0u);
}

TEST(PictureSvg, CutsATitleThatIsTooLongBetweenCharacters) {
  EXPECT_EQ(shortened("short", 100.0, 12.0), "short");
  const std::string cut = shortened("νννννννννννννννννννν", 100.0, 12.0);
  EXPECT_TRUE(cut.ends_with("ν…")) << cut;
  EXPECT_LE(text_width(cut, 12.0), 100.0);
}

TEST(PictureSvg, WithoutLoadsShowsTheSystemAlone) {
  Picture plate = fixture::make_grid();
  plate.loads.clear();
  const std::string picture = picture_svg(plate);
  EXPECT_EQ(fixture::WellFormed(picture).error(), "");
  EXPECT_EQ(count(picture, "<g class=\"springs\""), 1u);
}

TEST(SystemPanel, MarksMassesThatArentPositive) {
  const Picture plate = fixture::make_disc();
  const std::string panel = system_panel(plate, 240.0, StiffnessColours({&plate})).text;
  EXPECT_EQ(count(panel, "class=\"massless\""), 2u + 1u);  // and one in the key
  EXPECT_EQ(count(panel, "class=\"mass\""), plate.nodes.size() - 2u + 1u);
}

// Areas as masses: a node of a quarter of the mass has half the radius.
TEST(SystemPanel, SizesNodesByMass) {
  Picture plate = fixture::make_square("start", 0.5);
  plate.masses = {0.1, 0.4, 0.4, 0.4};
  const std::string panel = system_panel(plate, 240.0, StiffnessColours({&plate})).text;
  EXPECT_EQ(count(panel, "r=\"8.00\"/>"), 3u);
  EXPECT_EQ(count(panel, "r=\"4.00\"/>"), 1u);
  EXPECT_EQ(count(panel, "r=\"5.66\"/>"), 1u);  // the key's 0.2 kg
}

TEST(SystemPanel, HasOneScaleForBothAxes) {
  Picture plate = fixture::make_grid();
  const Frame frame = make_rest_frame(plate, 240.0, 22.0);
  const Point origin = frame.at({0, 0}), right = frame.at({3, 0}), up = frame.at({0, 2});
  EXPECT_NEAR((right[0] - origin[0]) / 3.0, (origin[1] - up[1]) / 2.0, 1e-12);
  for (Point& node : plate.nodes) node = {0.01 * node[0], 5.0 * node[1]};
  plate.rings.clear();
  const Frame tall = make_rest_frame(plate, 240.0, 22.0);
  EXPECT_LE(tall.height, 1.25 * 240.0 + 1e-9);
  EXPECT_NEAR(tall.at({0.015, 0.0})[0], 120.0, 1e-9);  // in the middle
}

TEST(LoadPanel, DrawsNoReferenceWhereNoneIsKnown) {
  Picture plate = fixture::make_frame_with_hole();
  const Frame frame = make_frame({&plate});
  const StiffnessColours colours({&plate});
  PicturedLoad& load = plate.loads[0];
  // Crosses are two strokes each, a bar for the one known in x only is one.
  const std::string panel = load_panel(plate, load, frame, colours);
  const std::string known =
      panel.substr(panel.find("class=\"known\""), panel.find("class=\"held\"") - panel.find("class=\"known\""));
  EXPECT_EQ(count(known, "M"), 6u * 2u + 1u);
  EXPECT_EQ(count(panel, "class=\"body\""), 1u);  // between the three neighbours on the right
  load.known.assign(plate.nodes.size(), {false, false});
  const std::string without = load_panel(plate, load, frame, colours);
  EXPECT_EQ(count(without, "class=\"known\""), 0u);
  EXPECT_EQ(count(without, "class=\"body\""), 0u);
  // What is said there doesn't matter either.
  for (Point& u : load.reference) u = {7.0, 7.0};
  EXPECT_EQ(load_panel(plate, load, frame, colours), without);
}

TEST(LoadPanel, DottedLinesOfADenseGridAreEverySoManyth) {
  Picture plate;
  plate.columns = 61;
  for (int j = 0; j < 61; ++j)
    for (int i = 0; i < 61; ++i) plate.nodes.push_back({1.0 * i, 1.0 * j});
  for (std::size_t n = 0; n + 1 < plate.nodes.size(); ++n)
    if (n % 61 != 60) plate.springs.push_back({n, n + 1, 1.0});
  PicturedLoad load;
  load.displacement = load.reference = load.forces = std::vector<Point>(plate.nodes.size(), {0.0, 0.0});
  plate.loads = {load};
  // 240 units less margins for 60 cells: 3.1 each, so every third row of 61.
  const std::string panel = load_panel(plate, load, make_frame({&plate}), StiffnessColours({&plate}));
  const std::string body = panel.substr(panel.find("class=\"body\""));
  EXPECT_EQ(count(body, "M"), 21u);
}

TEST(DrawnSprings, AreAllOfAnOrdinaryNetAndAnEvenShareOfALargeOne) {
  const Picture small = fixture::make_disc();
  EXPECT_EQ(DrawnSprings(small, small.springs.size()).count(), small.springs.size());
  Picture large;
  large.nodes.assign(4, {0.0, 0.0});
  large.kinds = {NodeKind::border, NodeKind::corner, NodeKind::inner, NodeKind::inner};
  for (std::size_t e = 0; e < 100'000; ++e)
    large.springs.push_back({e % 1000 == 0 ? 1u : 2u, e % 1000 == 0 ? 0u : 3u, 1.0});
  const DrawnSprings drawn(large, 20'000);
  // 20,000 of 100,000 by lot, a binomial of deviation 126, and the border's 100 whether drawn or not.
  EXPECT_NEAR(static_cast<double>(drawn.count()), 20'080.0, 5.0 * 126.0);
  for (std::size_t e = 0; e < large.springs.size(); e += 1000) EXPECT_TRUE(drawn.contains(e));
  EXPECT_EQ(picture_legend(large, make_frame({&large})).back(),
            fmt::format("{} springs are drawn at rest.", DrawnSprings(large, 60'000).count()));
  large.springs.resize(30'000);
  large.loads.resize(1);
  for (auto* vectors : {&large.loads[0].displacement, &large.loads[0].reference, &large.loads[0].forces})
    vectors->assign(4, {0.0, 0.0});
  EXPECT_EQ(picture_legend(large, make_frame({&large})).back(),
            fmt::format("{} springs are drawn under each load.", DrawnSprings(large, 20'000).count()));
}

TEST(LoadPanel, KeepsArrowsAndSupportsApart) {
  Picture plate;
  for (int i = 0; i <= 1000; ++i) plate.nodes.push_back({0.001 * i, 0.0});
  plate.nodes.push_back({0.0, 1.0});
  for (std::size_t i = 0; i < 1000; ++i) plate.springs.push_back({i, i + 1, 1.0});
  PicturedLoad load;
  load.displacement = load.reference = std::vector<Point>(plate.nodes.size(), {0.0, 0.0});
  load.forces.assign(plate.nodes.size(), {0.0, 1.0});
  for (std::size_t i = 0; i <= 1000; ++i) load.fixed.push_back(i);
  plate.loads = {load};
  const Frame frame = make_frame({&plate});
  const std::string panel = load_panel(plate, load, frame, StiffnessColours({&plate}));
  // An arrow is two moves; of the line's nodes every `step`th has one, 6 units apart or a little more, and the node
  // above.
  const std::string arrows =
      panel.substr(panel.find("class=\"force\""), panel.find("<rect") - panel.find("class=\"force\""));
  const auto step = static_cast<std::size_t>(std::ceil(6.0 / (0.001 * frame.unit)));
  EXPECT_EQ(count(arrows, "M"), 2u * (1000u / step + 1u + 1u));
  EXPECT_LT(count(panel, "<rect"), 62u);  // 2.5 and 1.5 units on at most 240
  EXPECT_GT(count(panel, "<rect"), 40u);
}

TEST(ColourScale, NumbersEndsAndPowersOfTenThatFit) {
  Picture plate = fixture::make_square("start", 0.5);
  plate.springs = {{0, 1, 0.0023}, {2, 3, 1.0}, {0, 2, 47.0}};
  const std::string scale = colour_scale(StiffnessColours({&plate}), 240.0).text;
  for (const char* label : {">0.00230<", ">0.1<", ">1<", ">47.0 N/m<"}) EXPECT_EQ(count(scale, label), 1u) << label;
  EXPECT_EQ(count(scale, ">0.01<"), 0u);  // runs into the lower end's
  const std::string ticks = scale.substr(scale.find("class=\"tick\""),
                                         scale.find("/>", scale.find("class=\"tick\"")) - scale.find("class=\"tick\""));
  EXPECT_EQ(count(ticks, "M"), 4u);
}

TEST(ColourScale, OfOneStiffnessIsOnePatch) {
  Picture plate = fixture::make_square("start", 0.5);
  for (PicturedSpring& s : plate.springs) s.stiffness = 0.25;
  const std::string scale = colour_scale(StiffnessColours({&plate}), 240.0).text;
  EXPECT_EQ(count(scale, "<rect"), 1u);
  EXPECT_EQ(count(scale, ">all 0.250 N/m<"), 1u);
}

TEST(MechanismSvg, ShowsWhatMovesAndNothingElse) {
  Mechanism mechanism = fixture::make_mechanism();
  const std::string picture = mechanism_svg(mechanism);
  EXPECT_EQ(count(picture, "class=\"moving\""), 4u);
  EXPECT_EQ(count(picture, "4 of 12 nodes"), 1u);
  EXPECT_EQ(count(picture, ">10</text>"), 1u);
  mechanism.motion.pop_back();
  EXPECT_THROW((void)mechanism_svg(mechanism), std::invalid_argument);
}

}  // namespace
}  // namespace nodal::elastic::show
