// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of output that can't be written, and of texts that a terminal would obey.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <fstream>

#include <nodal/store.h>

#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

const std::vector<std::vector<std::string>> kPrinting = {
    {"explain", "quick.toml"},
    {"evaluate", "quick.toml"},
    {"evaluate", "quick.toml", "--json"},
    {"fit", "quick.toml", "--with", "annealing", "--evaluations", "5"},
    {"list"},
    {"list", "topologies"},
    {"compare", "quick.toml"},
    {"report", "results/quick"},
    {"--help"},
    {"compare", "--help"},
    {"--version"},
};

TEST(StandardOutput, ThatIsFullOrClosedIsAnError) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  for (const std::vector<std::string>& arguments : kPrinting) {
    const Output full = run(folder, arguments, Stdout::full), closed = run(folder, arguments, Stdout::closed);
    EXPECT_EQ(full.exit, 2) << arguments[0];
    EXPECT_TRUE(full.err.ends_with("nodal: cannot write to standard output: No space left on device\n")) << full.err;
    EXPECT_EQ(closed.exit, 2) << arguments[0];
    EXPECT_TRUE(closed.err.ends_with("nodal: cannot write to standard output: Bad file descriptor\n")) << closed.err;
  }
}

TEST(StandardOutput, ThatNobodyReadsAnyMoreEndsAsTheShellSays) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  for (const std::vector<std::string>& arguments : kPrinting) {
    const Output output = run(folder, arguments, Stdout::gone);
    EXPECT_EQ(output.exit, 128 + SIGPIPE) << arguments[0];
    EXPECT_FALSE(contains(output.err, "cannot write")) << output.err;
  }
}

// Whatever can't be printed: the files are there.
TEST(StandardOutput, IsWrittenAfterTheFiles) {
  for (const Stdout out : {Stdout::full, Stdout::closed, Stdout::gone, Stdout::both_gone}) {
    const Folder folder;
    folder.write("quick.toml", kQuickStudy);
    (void)run(folder, {"compare", "quick.toml"}, out);
    const std::filesystem::path store = folder.path() / "results" / "quick";
    EXPECT_EQ(count_lines(store / "trials"), 4u);
    for (const char* file : {"report.html", "summary.csv", "optimizers.csv", "budgets.csv"})
      EXPECT_TRUE(std::filesystem::exists(store / file)) << file;
    EXPECT_TRUE(Store::open_existing(store).warnings().empty());
    const Output fit =
        run(folder, {"fit", "quick.toml", "--with", "annealing", "--evaluations", "5", "--export", "k.json"}, out);
    EXPECT_EQ(fit.exit, 0);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "k.json"));
  }
}

// A text that could clear a screen, set a title, break a row, or read the other way round.
constexpr const char* kObeyed = R"(\u001b[2J\u001b]0;owned\u0007\r\nfake line: 1 2 3\u009b31m\u202E\u0000x)";

bool obeyed(const std::string& text) {
  const auto control = [](char c) { return (c >= 0 && c < 0x20 && c != '\n') || c == 0x7f; };
  return std::ranges::any_of(text, control) || contains(text, "\xC2\x9B") || contains(text, "\u202E");
}

constexpr const char* kShown = R"(\u001b[2J\u001b]0;owned\u0007\r\nfake line: 1 2 3\u009b31m)";

TEST(Console, ShowsControlCharactersRatherThanObeyingThem) {
  const Folder folder;
  folder.write("marked.toml", std::string(kQuickStudy) + "label = \"" + kObeyed + "\"\n");
  for (const char* command : {"compare", "explain", "evaluate", "fit"}) {
    const Output output = run(folder, {command, "marked.toml"});
    EXPECT_EQ(output.exit, 2);
    EXPECT_TRUE(contains(output.err, kShown)) << output.err;
    EXPECT_FALSE(obeyed(output.out + output.err)) << command;
  }
  folder.write("quick.toml", kQuickStudy);
  const Output error = run(folder, {"fit", "quick.toml", "--with", "\x1b[2J\nno"});
  EXPECT_EQ(error.exit, 2);
  EXPECT_TRUE(contains(error.err, R"(nodal: --with: '\u001b[2J\nno' is neither a label)")) << error.err;
  EXPECT_FALSE(obeyed(error.err));
}

// A store may have any label, whoever made it.
TEST(Console, ShowsControlCharactersOfStoredLabels) {
  const Folder folder;
  folder.write("quick.toml", std::string(kQuickStudy) + "label = \"marked\"\n");
  ASSERT_EQ(run(folder, {"compare", "quick.toml"}).exit, 0);
  const std::filesystem::path store = folder.path() / "results" / "quick";
  std::vector<std::filesystem::path> files = {store / "manifest.json"};
  for (const auto& entry : std::filesystem::directory_iterator(store / "trials")) files.push_back(entry.path());
  for (const std::filesystem::path& file : files) {
    std::string text = read_file(file);
    const std::string label = "\"marked\"";
    for (std::size_t at = 0; (at = text.find(label, at)) != std::string::npos;)
      text.replace(at, label.size(), "\"" + std::string(kObeyed) + "\"");
    std::ofstream(file) << text;
  }
  const Output output = run(folder, {"report", "results/quick"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.out, kShown)) << output.out;
  EXPECT_FALSE(obeyed(output.out + output.err));
  EXPECT_FALSE(contains(output.out, "\nfake line"));
}

// A NUL doesn't cut a message off.
TEST(Console, ShowsTheWholeMessage) {
  const Folder folder;
  folder.write("esc.toml", "[study]\n\"a\\u0000b\\u001b\" = 1\n[problem]\nkind = \"sphere\"\n");
  const Output output = run(folder, {"explain", "esc.toml"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_TRUE(contains(output.err, R"('a\u0000b\u001b')")) << output.err;
}

}  // namespace
}  // namespace nodal::program
