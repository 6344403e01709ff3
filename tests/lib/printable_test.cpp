// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nodal/shown.h>
#include <nodal/value.h>

namespace nodal {
namespace {

TEST(Printable, LeavesTextAlone) {
  for (const char* text : {"", "annealing (baseline)", "Zufällige Größe µ×–", "日本語", "😀 [0.1, 0.2]"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, ShowsWhatATerminalWouldObey) {
  using namespace std::string_view_literals;
  EXPECT_EQ(printable("\x1b[31mRED\x1b]0;owned\x07\x1b[2J"), "\\u001b[31mRED\\u001b]0;owned\\u0007\\u001b[2J");
  EXPECT_EQ(printable("a\0b\x7f"sv), "a\\u0000b\\u007f");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\u009b31m");  // C1: CSI in one character
  EXPECT_EQ(printable("\u202Eleft\u2066\u200F\u061C"), "\\u202eleft\\u2066\\u200f\\u061c");
  EXPECT_EQ(printable("a\u2028b\u2029c"), "a\\u2028b\\u2029c");
}

TEST(Printable, ShowsBreaksOrKeepsThem) {
  EXPECT_EQ(printable("a\r\nb\tc"), "a\\r\\nb\\tc");
  EXPECT_EQ(printable("a\r\nb\tc", Breaks::keep), "a\\r\nb\tc");
}

// 0x9B alone is CSI for a terminal that reads bytes; overlong forms spell ESC; a lead without the rest swallows a
// quote.
TEST(Printable, ReplacesWhatIsNoUtf8) {
  EXPECT_EQ(printable("\x9B"
                      "31m"),
            "\uFFFD31m");
  EXPECT_EQ(printable("\xC0\x9B"
                      "x"),
            "\uFFFD\uFFFDx");
  EXPECT_EQ(printable("\xE0\x80\x9B"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(printable("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // a surrogate
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(printable("\xE2\x82'"), "\uFFFD\uFFFD'");
}

TEST(Printable, LeavesJsonTheSameJson) {
  Value value;
  value.set("a\u202Eb", "x\u0085y\x7f");
  const std::string json = to_json(value);
  EXPECT_NE(printable(json), json);
  EXPECT_EQ(parse_json(printable(json), "shown"), value);
}

TEST(UnfinishedBytes, AreThoseOfACharacterThatIsNotWhole) {
  const std::string text = "aé€😀";
  const std::size_t expected[] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3, 0};
  for (std::size_t size = 0; size <= text.size(); ++size)
    EXPECT_EQ(unfinished_bytes(std::string_view(text).substr(0, size)), expected[size]) << size;
  EXPECT_EQ(unfinished_bytes("\x9B\x9B\x9B\x9B"), 0u);
}

}  // namespace
}  // namespace nodal
