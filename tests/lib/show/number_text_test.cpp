// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/show/number_text.h>

#include <gtest/gtest.h>

namespace nodal {
namespace {

TEST(NumberText, SecondsTakeAUnitByMagnitude) {
  EXPECT_EQ(seconds_text(4.3e-7), "430 ns");
  EXPECT_EQ(seconds_text(0.00172), "1.72 ms");
  EXPECT_EQ(seconds_text(12.34), "12.3 s");
  EXPECT_EQ(seconds_text(150.0), "150 s");
  EXPECT_EQ(seconds_text(900.0), "15.0 min");
  EXPECT_EQ(seconds_text(0.0), "0 s");
}

TEST(NumberText, RoundingUpToTheNextUnitIsWrittenInThatUnit) {
  EXPECT_EQ(seconds_text(0.9996), "1.00 s");
  EXPECT_EQ(seconds_text(0.9994), "999 ms");
  EXPECT_EQ(figure_text(9.9996, 4), "10.00");
  EXPECT_EQ(count_text(999999.6), "1.00 M");
}

TEST(NumberText, FiguresKeepTheirDigits) {
  EXPECT_EQ(figure_text(0.0922032, 4), "0.09220");
  EXPECT_EQ(figure_text(0.7376255865, 4), "0.7376");
  EXPECT_EQ(figure_text(-2.304, 4), "-2.304");
  EXPECT_EQ(figure_text(1.234e-9, 4), "1.234e-9");
  EXPECT_EQ(figure_text(12345678.0, 4), "1.235e7");
  EXPECT_EQ(figure_text(0.0, 4), "0");
}

TEST(NumberText, CountsAreGrouped) {
  EXPECT_EQ(count_text(7.0), "7");
  EXPECT_EQ(count_text(999.5), "1,000");
  EXPECT_EQ(count_text(20736.0), "20,736");
  EXPECT_EQ(count_text(1.25e6), "1.25 M");
  EXPECT_EQ(count_text(3.4e9), "3.40 G");
}

TEST(NumberText, GapsAreWrittenAsTheyAreSpokenOf) {
  EXPECT_EQ(gap_text(1e-1), "0.1");
  EXPECT_EQ(gap_text(1e-3), "0.001");
  EXPECT_EQ(gap_text(1e-6), "1e-6");
}

TEST(NumberText, WidthIsWhatATerminalNeeds) {
  EXPECT_EQ(display_width("abc"), 3u);
  EXPECT_EQ(display_width("12×"), 3u);
  EXPECT_EQ(display_width("µs – Größe"), 10u);
  EXPECT_EQ(display_width("e\u0301"), 1u);
  EXPECT_EQ(display_width("弾性"), 4u);
}

}  // namespace
}  // namespace nodal
