// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of plain text: their lines, their columns, their numbers.
#include "import/csv.h"

#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

#include <nodal/random.h>

#include "../../../support/messages.h"

namespace nodal::elastic {
namespace {

const std::vector<Column> kColumns = {{"a", true}, {"b"}, {"name"}};

CsvTable table(const std::string& text, const ColumnNames& names = {}) { return {text, "t.csv", kColumns, names}; }
std::string table_refusal(const std::string& text, const ColumnNames& names = {}) {
  return toy::message_of([&] { (void)table(text, names); });
}
// What is said of the one number of a table.
std::string number_refusal(const std::string& field) {
  return toy::message_of([&] { (void)table("a\tb\n" + field + "\t1\n").row(0).required_number("a"); });
}

TEST(Csv, ReadsColumnsInAnyOrderAndLeavesOutComments) {
  const CsvTable t = table("# made by hand\n\nb, a\n 1 , 2\n# half\n+3,-4e1\n");
  ASSERT_EQ(t.size(), 2u);
  EXPECT_EQ(t.row(0).number("a"), 2.0);
  EXPECT_EQ(t.row(1).number("a"), -40.0);
  EXPECT_EQ(t.row(1).number("b"), 3.0);
  EXPECT_EQ(t.row(1).source().text(), "t.csv:6");
  EXPECT_FALSE(t.has("name"));
  EXPECT_EQ(t.row(0).text("name"), "");
}

TEST(Csv, ReadsSemicolonsTabsQuotesAndWhatSpreadsheetsWrite) {
  EXPECT_EQ(table("a;name\n1;x\n").row(0).text("name"), "x");
  EXPECT_EQ(table("a\tname\n1\tx y\n").row(0).text("name"), "x y");
  EXPECT_EQ(table("a\tb\tname\n1\t\t\n").row(0).number("a"), 1.0);
  EXPECT_EQ(table("\xEF\xBB\xBF\"a\",name\r\n1,\"he said \"\"so, so\"\"\"\r\n").row(0).text("name"),
            "he said \"so, so\"");
  EXPECT_EQ(table("a,name\n1,\n").row(0).text("name"), "");
  EXPECT_EQ(table("sep=;\r\na;name\r\n1;x,y\r\n").row(0).text("name"), "x,y");
  EXPECT_EQ(table("sep=,\na,name\n1,x;y\n").row(0).text("name"), "x;y");
}

TEST(Csv, SkipsEmptyColumnsAndRowsThatTrailingSeparatorsMake) {
  for (const char* text : {"a,b,\n1,2,\n", "a,b\n1,2,\n", "a,b,,,\n1,2\n", "a,b\n1,2\n,,\n,\n"}) {
    const CsvTable t = table(text);
    ASSERT_EQ(t.size(), 1u) << text;
    EXPECT_EQ(t.row(0).number("b"), 2.0) << text;
  }
  EXPECT_EQ(table_refusal("a,b,\n1,2,3\n"), "t.csv:2: 3 fields, where the first line names 2 columns: a, b");
  EXPECT_EQ(table_refusal("a,,b\n1,,2\n"), "t.csv:1: column 2 has no name");
}

TEST(Csv, TakesIntegersThatAreWrittenAsNumbers) {
  const auto integer = [](const char* field) { return table(fmt::format("a\n{}\n", field)).row(0).integer("a"); };
  EXPECT_EQ(integer("1.0"), 1);
  EXPECT_EQ(integer("-2e3"), -2000);
  EXPECT_EQ(integer("9223372036854775807"), 9223372036854775807);
  for (const char* field : {"1.5", "1e300", "nan", "1e17", "x"})
    EXPECT_EQ(toy::message_of([&] { (void)integer(field); }),
              fmt::format("t.csv:2: 'a' is '{}'; it must be an integer", field));
}

TEST(Csv, TakesNanInAnySpellingForNotMeasured) {
  const auto measured = [](const std::string& field) { return table("a,b\n" + field + ",1\n").row(0).measured("a"); };
  for (const char* field : {"", "nan", "NaN", "-nan", "+NAN", "-nan(ind)", "nan(snan)"})
    EXPECT_FALSE(measured(field).has_value()) << field;
  EXPECT_EQ(measured("-0.5"), -0.5);
  for (const char* field : {"inf", "N/A", "-", "nano"})
    EXPECT_EQ(
        toy::message_of([&] { (void)measured(field); }),
        fmt::format("t.csv:2: 'a' is '{}'; it must be a finite number, or empty or NaN where nothing was measured",
                    field));
}

TEST(Csv, RefusesWhatItCannotRead) {
  EXPECT_EQ(table_refusal(""), "t.csv: the file is empty; its first line must name the columns");
  EXPECT_EQ(table_refusal("b\n1\n"), "t.csv:1: column 'a' is missing; possible columns: a, b, name");
  EXPECT_EQ(
      table_refusal("a,nome\n"),
      "t.csv:1: unknown column 'nome'; did you mean 'name'? such a table is read by columns = { a = \"a\", name = "
      "\"nome\" }");
  EXPECT_EQ(
      table_refusal("A [m],B,strain_xx\n"),
      "t.csv:1: unknown column 'A [m]'; valid: 'a', 'b', 'name'; such a table is read by columns = { a = \"A [m]\", "
      "b = \"B\" }");
  EXPECT_EQ(table_refusal("a,a\n"), "t.csv:1: column 'a' stands twice");
  EXPECT_EQ(table_refusal("a,b\n1\n"), "t.csv:2: 1 fields, where the first line names 2 columns: a, b");
  EXPECT_EQ(table_refusal("a,name\n1,\"x\n"), "t.csv:2: a quoted field doesn't end on its line");
  EXPECT_EQ(table_refusal("a\n1,5\n"), "t.csv:2: 2 fields, where the first line names 1 columns: a");
  EXPECT_EQ(number_refusal("1.5m"), "t.csv:2: 'a' is '1.5m'; it must be a finite number");
  EXPECT_EQ(number_refusal("nan"), "t.csv:2: 'a' is 'nan'; it must be a finite number");
  EXPECT_EQ(number_refusal("\"\""), "t.csv:2: 'a' is empty; it must be a number");
}

TEST(Csv, RefusesWhatFollowsAClosingQuote) {
  EXPECT_EQ(table_refusal("a,b\n\"0\"zzz,0\n"),
            "t.csv:2: 'zzz' follows the closing quote of '0'; a quoted field ends with its quote");
  EXPECT_EQ(table_refusal("a,b\n1,\"1\"5\n"),
            "t.csv:2: '5' follows the closing quote of '1'; a quoted field ends with its quote");
  EXPECT_EQ(table_refusal("\"a\"b,b\n"),
            "t.csv:1: 'b' follows the closing quote of 'a'; a quoted field ends with its quote");
  EXPECT_EQ(table("a,b\n\"1\" , \"2\" \n").row(0).number("b"), 2.0);
}

TEST(Csv, NamesTheCauseWhereItCanBeSeen) {
  EXPECT_EQ(table_refusal(std::string("\xFF\xFE"
                                      "a\0,\0b\0\n\0",
                                      10)),
            "t.csv: the file is in UTF-16; save it as UTF-8");
  EXPECT_EQ(table_refusal(std::string("a\0\n\0", 4)),
            "t.csv: the file has bytes that are 0: it is in UTF-16, or no text; save it as UTF-8");
  EXPECT_EQ(
      table_refusal("a,b\r1,2\r"),
      "t.csv:1: a carriage return without a line feed, as lines of an old Mac end; save the file with line ends LF or "
      "CRLF");
  EXPECT_EQ(table_refusal("0,0\n1,2\n"),
            "t.csv:1: the first line, '0,0', has numbers; it must name the columns, of a, b, name");
  EXPECT_EQ(table_refusal("0 0\n1 2\n"),
            "t.csv:1: the first line, '0 0', has numbers; it must name the columns, of a, b, name");
  EXPECT_EQ(
      table_refusal("a b\n1 2\n"),
      "t.csv:1: the first line, 'a b', is one column: blanks don't separate columns, commas, semicolons and tabs do");
  EXPECT_EQ(table_refusal("a,b\nm,m\n1,2\n"),
            "t.csv:2: 'm,m' has no numbers: of lines above the rows there may be one, which names the columns; put # "
            "in front "
            "of others");
  EXPECT_EQ(table_refusal("sep=|\na|b\n"), "t.csv:1: the separator is '|'; it may be a comma, a semicolon or a tab");
  EXPECT_EQ(number_refusal("0,5"),
            "t.csv:2: 'a' is '0,5'; it must be a finite number; a point is the decimal separator");
  for (const char* field : {"1.0D+00", "4.0+0", "2.3-12"})
    EXPECT_EQ(number_refusal(field),
              fmt::format("t.csv:2: 'a' is '{}'; it must be a finite number; exponents are written "
                          "with e, as in 1.0e+00",
                          field));
}

TEST(Csv, ReadsTheColumnsThatAreNamedAndNoOthers) {
  const ColumnNames names = {{{"a", "x [mm]"}, {"name", "a"}}, {"s.toml", 3}};
  const CsvTable t = table("d,x [mm],a,b,\n0,1,n,7\n", names);
  EXPECT_EQ(t.row(0).number("a"), 1.0);
  EXPECT_EQ(t.row(0).text("name"), "n");
  EXPECT_FALSE(t.has("b"));
  EXPECT_EQ(t.left_out(), "t.csv: columns d, b are left out");
  EXPECT_EQ(table("x [mm],a,,c\n1,n,2,3\n", names).left_out(), "t.csv: columns , c are left out");
  EXPECT_EQ(table("a,b\n1,2\n").left_out(), "");
  EXPECT_EQ(table_refusal("x,a\n1,n\n", names),
            "s.toml:3: 'columns' calls 'a' 'x [mm]', and t.csv:1 has no such column; valid: 'x', 'a'");
  EXPECT_EQ(table_refusal("x [mm],a,a\n", names), "t.csv:1: column 'a' stands twice");
  EXPECT_EQ(table_refusal("a,b\n", {{{"b", "b"}}, {"s.toml", 3}}),
            "s.toml:3: 'columns' must name 'a', too: with it, only what it names is read");
  EXPECT_EQ(table_refusal("a,b\n", {{{"a", "b"}, {"b", "b"}}, {"s.toml", 3}}),
            "s.toml:3: 'columns' takes 'b' for both 'a' and 'b'");
}

// ── any table, in any of its spellings

struct Spelling {
  std::string separator, line_end, front;
  bool quoted, spaced, trailing, comments;
};

Spelling random_spelling(RandomStream& random) {
  const char* separators[] = {",", ";", "\t"};
  const char* fronts[] = {"", "\xEF\xBB\xBF", "# what it is\n", "\n\n"};
  const std::string separator = separators[random.index(3)];
  const bool said = separator != "\t" && random.index(4) == 0;
  return {separator,
          random.index(2) ? "\n" : "\r\n",
          fronts[random.index(4)] + (said ? "sep=" + separator + "\n" : std::string()),
          random.index(2) == 0,
          random.index(2) == 0 && separator != "\t",
          random.index(2) == 0,
          random.index(2) == 0};
}

std::string spelled(const std::vector<std::vector<std::string>>& lines, const Spelling& spelling) {
  std::string text = spelling.front;
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i > 0) text += spelling.separator;
      std::string field = line[i];
      for (std::size_t at = field.find('"'); at != std::string::npos; at = field.find('"', at + 2))
        field.insert(at, "\"");
      const bool must = line[i].find_first_of(",;\t\" #") != std::string::npos;
      if (spelling.spaced) text += " ";
      text += spelling.quoted || must ? "\"" + field + "\"" : field;
      if (spelling.spaced) text += " ";
    }
    text += (spelling.trailing ? spelling.separator : "") + spelling.line_end;
    if (spelling.comments)
      text += "# " + spelling.line_end + spelling.line_end + spelling.separator + spelling.line_end;
  }
  return text;
}

TEST(CsvProperty, ATableIsTheSameInAllOfItsSpellings) {
  RandomStream random(17);
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::vector<std::string>> lines = {{"name", "b", "a"}};
    std::vector<double> numbers;
    for (std::size_t rows = 1 + random.index(5); rows > 0; --rows) {
      numbers.push_back(std::ldexp(random.uniform(-1, 1), static_cast<int>(random.index(200)) - 100));
      const char* names[] = {"x", "so, so", "a;b", "he said \"no\"", "ν", "tab\there"};
      lines.push_back({names[random.index(6)], random.index(2) ? "" : "3", fmt::format("{}", numbers.back())});
    }
    const std::string text = spelled(lines, random_spelling(random));
    const CsvTable t = table(text);
    ASSERT_EQ(t.size(), numbers.size()) << text;
    for (std::size_t r = 0; r < numbers.size(); ++r) {
      ASSERT_EQ(t.row(r).number("a"), numbers[r]) << text;
      ASSERT_EQ(t.row(r).text("name"), lines[r + 1][0]) << text;
      ASSERT_EQ(t.row(r).integer("b").has_value(), lines[r + 1][1] == "3") << text;
    }
  }
}

}  // namespace
}  // namespace nodal::elastic
