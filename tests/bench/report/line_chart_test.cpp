// SPDX-License-Identifier: GPL-3.0-or-later
#include <report/chart/end_labels.h>
#include <report/chart/figures_table.h>
#include <report/chart/line_chart.h>
#include <report/chart/line_styles.h>
#include <report/chart/path_text.h>
#include <report/chart/svg_chart.h>
#include <report/chart/ticks.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <regex>
#include <set>

#include "../../support/count.h"

namespace nodal::report {
namespace {

ChartLine line(const std::string& label, std::vector<std::array<double, 2>> points) {
  ChartLine made{.label = label};
  for (const auto& [x, y] : points) made.points.push_back({x, y, y, y});
  return made;
}

LineChart chart(std::vector<ChartLine> lines) {
  return {.title = "errors",
          .description = "who is where",
          .x = {"time", Scale::logarithmic, true},
          .y = {"error"},
          .lines = std::move(lines)};
}

using toy::count;

TEST(Ticks, AreRoundAndAsManyAsThereIsRoomFor) {
  EXPECT_EQ(ticks({0.9, 110.0}, Scale::logarithmic, 8), (std::vector<double>{1, 2, 5, 10, 20, 50, 100}));
  EXPECT_EQ(ticks({1e-4, 1e4}, Scale::logarithmic, 5), (std::vector<double>{1e-4, 1e-2, 1.0, 1e2, 1e4}));
  EXPECT_EQ(ticks({0.0, 1.0}, Scale::linear, 6), (std::vector<double>{0.0, 0.2, 0.4, 0.6, 0.8, 1.0}));
  // Less than a factor of 2 between the ends: evenly.
  EXPECT_EQ(ticks({0.092, 0.0945}, Scale::logarithmic, 4), (std::vector<double>{0.092, 0.093, 0.094}));
  EXPECT_EQ(ticks({3.0, 3.0}, Scale::linear, 4), (std::vector<double>{3.0}));
}

TEST(Ticks, AreWrittenAsPeopleDo) {
  EXPECT_EQ(tick_text(0.02, false), "0.02");
  EXPECT_EQ(tick_text(20000.0, false), "20,000");
  EXPECT_EQ(tick_text(1e-6, false), "10⁻⁶");
  EXPECT_EQ(tick_text(3e7, false), "3×10⁷");
  EXPECT_EQ(tick_text(0.0, true), "0");
  EXPECT_EQ(tick_text(0.02, true), "20 ms");
  EXPECT_EQ(tick_text(5e-6, true), "5 µs");
  EXPECT_EQ(tick_text(200.0, true), "200 s");
}

TEST(EndLabels, StayWhereTheyBelongIfTheyCan) {
  EXPECT_EQ(place_labels({100.0, 20.0, 50.0}, 12.0, 0.0, 200.0), (std::vector<double>{100.0, 20.0, 50.0}));
  EXPECT_TRUE(place_labels({}, 12.0, 0.0, 200.0).empty());
}

TEST(EndLabels, KeepTheirDistanceOrderAndMean) {
  EXPECT_EQ(place_labels({50.0, 50.0, 50.0}, 10.0, 0.0, 200.0), (std::vector<double>{40.0, 50.0, 60.0}));
  const std::vector<double> wanted = {10.0, 12.0, 13.0, 90.0, 91.0, 199.0, 200.0, 5.0};
  const std::vector<double> places = place_labels(wanted, 10.0, 5.0, 195.0);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_GE(places[i], 5.0);
    EXPECT_LE(places[i], 195.0);
    for (std::size_t j = 0; j < wanted.size(); ++j)
      if (wanted[i] < wanted[j]) {
        EXPECT_GE(places[j] - places[i], 10.0 - 1e-9);
      }
  }
  EXPECT_DOUBLE_EQ(places[3] + places[4], 181.0);  // a pair alone lies about its mean
}

// WCAG 2.1: relative luminance, contrast.
double luminance(std::string_view colour) {
  double sum = 0.0;
  constexpr std::array<double, 3> kWeights = {0.2126, 0.7152, 0.0722};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = std::stoi(std::string(colour.substr(1 + 2 * i, 2)), nullptr, 16) / 255.0;
    sum += kWeights[i] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}
double contrast(std::string_view a, std::string_view b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

TEST(LineStyles, AreSeenOnBothPagesAndAllDiffer) {
  std::set<std::string> light, looks;
  for (std::size_t i = 0; i < kLineColours; ++i) {
    const LineStyle style = line_style(i);
    EXPECT_GE(contrast(style.light, "#ffffff"), 3.0) << style.light;
    EXPECT_GE(contrast(style.dark, "#14171b"), 3.0) << style.dark;
    light.emplace(style.light);
  }
  EXPECT_EQ(light.size(), kLineColours);
  for (std::size_t i = 0; i < 2 * kLineColours; ++i)
    looks.insert(std::string(line_style(i).light) + std::string(line_style(i).dash));
  EXPECT_EQ(looks.size(), 2 * kLineColours);
}

TEST(LineChart, LeavesOutWhatAnAxisHasNoPlaceFor) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const LineChart drawn = drawable(chart(
      {line("a", {{0.0, 1.0}, {1.0, 2.0}, {2.0, nan}, {3.0, 0.0}, {4.0, 1e200}}), line("nothing", {{0.0, 1.0}})}));
  ASSERT_EQ(drawn.lines.size(), 1u);
  ASSERT_EQ(drawn.lines[0].points.size(), 1u);
  EXPECT_EQ(drawn.lines[0].points[0].x, 1.0);
}

TEST(LineChart, ClampsAndThins) {
  ChartLine falling{.label = "a"};
  for (int i = 1; i <= 1000; ++i) {
    const double y = std::pow(10.0, -0.02 * i);
    falling.points.push_back({static_cast<double>(i), y, y, y});
  }
  LineChart all = chart({falling});
  all.y.clamped_to = {1e-9, 1.0};
  const LineChart drawn = drawable(all);
  const std::vector<ChartPoint> few = thinned(drawn.lines[0], drawn.x);
  ASSERT_EQ(few.size(), kMostChartPoints);
  EXPECT_EQ(few.front().x, 1.0);
  EXPECT_EQ(few.back().x, 1000.0);
  EXPECT_EQ(few.back().y, 1e-9);
}

// At evenly many places along the axis they are as high as all steps; what figures are told from is all of them.
TEST(LineChart, ThinsStepsAlongTheAxis) {
  ChartLine steps{.label = "a", .steps = true};
  for (int i = 1; i <= 999; ++i) steps.points.push_back({static_cast<double>(i), 1.0 / i, 0.5 / i, 2.0 / i});
  const LineChart drawn = drawable(chart({steps}));
  EXPECT_EQ(drawn.lines[0].points.size(), 999u);
  ChartLine few = drawn.lines[0];
  few.points = thinned(drawn.lines[0], drawn.x);
  EXPECT_LE(few.points.size(), kMostChartPoints);
  EXPECT_EQ(few.points.back().x, 999.0);
  for (int i = 0; i < 39; ++i) {
    const double place = std::pow(999.0, i / 39.0) * (1.0 + 1e-12);
    EXPECT_EQ(point_at(few, place, drawn.x, drawn.y)->y, point_at(drawn.lines[0], place, drawn.x, drawn.y)->y) << place;
  }
  EXPECT_NE(figures_table(chart({steps})).find("<td>0.0100</td>"), std::string::npos);
}

TEST(LineChart, ABandMayHaveNoUpperEnd) {
  ChartLine open = line("a", {{1.0, 1.0}, {100.0, 0.5}});
  open.steps = open.band = true;
  open.points[0].upper = std::numeric_limits<double>::infinity();
  LineChart all = chart({open});
  all.y.clamped_to = {1e-9, 1e50};
  const LineChart drawn = drawable(all);
  ASSERT_EQ(drawn.lines.at(0).points.size(), 2u);
  EXPECT_LT((*drawn.y.limits)[1], 2.0);
  EXPECT_EQ(count(svg_chart(all, "here"), "class=\"band\""), 1u);
  EXPECT_EQ(count(svg_chart(all, "here"), "inf"), 0u);
  EXPECT_NE(figures_table(all).find("<td>1.00<br><small>1.00 to –</small></td>"), std::string::npos)
      << figures_table(all);
}

TEST(LineChart, TellsTheHeightAtAPlace) {
  const LineChart drawn = drawable(chart({line("a", {{1.0, 1.0}, {100.0, 0.01}})}));
  EXPECT_FALSE(point_at(drawn.lines[0], 0.5, drawn.x, drawn.y));
  EXPECT_DOUBLE_EQ(point_at(drawn.lines[0], 10.0, drawn.x, drawn.y)->y, 0.1);
  EXPECT_DOUBLE_EQ(point_at(drawn.lines[0], 1000.0, drawn.x, drawn.y)->y, 0.01);
  ChartLine steps = drawn.lines[0];
  steps.steps = true;
  EXPECT_EQ(point_at(steps, 99.0, drawn.x, drawn.y)->y, 1.0);
}

TEST(SvgChart, HasNameDescriptionAndEveryLine) {
  LineChart two = chart({line("<first>", {{1e-3, 1.0}, {1e-1, 0.1}}), line("second", {{1e-3, 1.0}, {1.0, 0.01}})});
  two.lines[1].baseline = true;
  two.rule = ChartRule{0.005, "best known: 0.005"};
  const std::string svg = svg_chart(two, "here");
  EXPECT_NE(svg.find("role=\"img\" aria-labelledby=\"here-title here-desc\""), std::string::npos);
  EXPECT_NE(svg.find("<title id=\"here-title\">errors</title>"), std::string::npos);
  EXPECT_NE(svg.find("<desc id=\"here-desc\">who is where</desc>"), std::string::npos);
  EXPECT_EQ(count(svg, "class=\"curve\""), 2u);
  EXPECT_NE(svg.find(">&lt;first&gt;</text>"), std::string::npos);
  EXPECT_NE(svg.find(">second (baseline)</text>"), std::string::npos);
  EXPECT_NE(svg.find("best known: 0.005</text>"), std::string::npos);
  EXPECT_NE(svg.find(">100 ms</text>"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg, svg_chart(two, "here"));
}

TEST(PathText, SaysOfEachPlaceHowFarItIsFromTheLast) {
  PathText path;
  path.start(1205, 37).across_to(1205).across_to(1217).up_to(34).line_to(1207, 27).line_to(1207, 27).line_to(1206, 30);
  EXPECT_EQ(path.text(), "M120.5 3.7h1.2v-.3l-1-.7l-.1 .3");
  EXPECT_EQ(PathText().start(0, -5).line_to(0, 15).line_to(30, 15).text(), "M0-.5v2h3");
  EXPECT_EQ(PathText::tenths(-0.26), -3);
}

TEST(SvgChart, DrawsSharesAsSteps) {
  LineChart shares = chart({line("a", {{1.0, 0.0}, {10.0, 0.5}, {100.0, 1.0}})});
  shares.y = {"share", Scale::linear, false, std::array{0.0, 1.0}};
  shares.lines[0].steps = true;
  const std::string svg = svg_chart(shares, "shares");
  const std::regex steps(R"(class="curve"[^>]* d="M[\d.]+ [\d.]+(h[\d.]+v-?[\d.]+){2}")");
  EXPECT_TRUE(std::regex_search(svg, steps)) << svg;
  EXPECT_NE(svg.find(">0.2</text>"), std::string::npos);
}

TEST(SvgChart, OfNothingIsAnEmptyPlot) {
  for (const LineChart& empty : {chart({}), chart({line("a", {})})}) {
    EXPECT_EQ(count(svg_chart(empty, "none"), "class=\"curve\""), 0u);
    EXPECT_EQ(count(figures_table(empty), "scope=\"row\""), 0u);
  }
}

TEST(SvgChart, AsAFileIsXmlOfItsOwn) {
  const std::string svg = svg_chart_file(chart({line("a", {{1.0, 1.0}, {2.0, 0.5}})}));
  EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_EQ(count(svg, "var("), 0u);  // drawing programs know no variables
}

TEST(FiguresTable, HasAColumnPerTickAndWhatIsNotThereYet) {
  LineChart two = chart({line("early", {{1.0, 1.0}, {100.0, 0.01}}), line("late", {{10.0, 1.0}, {100.0, 0.5}})});
  two.lines[0].band = true;
  for (ChartPoint& p : two.lines[0].points) p.upper = 2.0 * p.y;
  two.x.limits = {1.0, 100.0};
  const std::string table = figures_table(two);
  EXPECT_NE(table.find("<th scope=\"col\">10 s</th>"), std::string::npos);
  EXPECT_NE(table.find("<tr><th scope=\"row\">late</th><td>–</td>"), std::string::npos);
  EXPECT_NE(table.find("<td>0.0100<br><small>0.0100 to 0.0200</small></td></tr>"), std::string::npos);
  EXPECT_NE(table.find("<caption>errors</caption>"), std::string::npos);
}

}  // namespace
}  // namespace nodal::report
