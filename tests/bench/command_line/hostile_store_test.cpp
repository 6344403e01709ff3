// SPDX-License-Identifier: GPL-3.0-or-later
// nodal report of a store from somebody else: it says what is wrong, and neither hangs nor reads what it shouldn't.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

#include <nodal/store.h>
#include <nodal/value.h>

#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

// A finished comparison, whose manifest and records a test spoils.
class HostileStore : public testing::Test {
 protected:
  HostileStore() {
    folder_.write("quick.toml", kQuickStudy);
    EXPECT_EQ(run(folder_, {"compare", "quick.toml"}).exit, 0);
    manifest_ = parse_json(read_file(store() / "manifest.json"), "manifest");
  }

  std::filesystem::path store() const { return folder_.path() / "results" / "quick"; }
  std::string page() const { return read_file(store() / "report.html"); }

  Output report_of(const Value& manifest) {
    folder_.write("results/quick/manifest.json", to_json(manifest));
    std::filesystem::remove(store() / "report.html");
    return run(folder_, {"report", "results/quick"});
  }

  // The study's text in another's words, with what is named in it beside the study.
  Output report_of_text(const std::string& text) {
    Value manifest = manifest_, study = manifest.at("study");
    study.set("text", text);
    manifest.set("study", study);
    return report_of(manifest);
  }

  Output report_of_records(const std::function<void(TrialRecord&)>& spoil) {
    for (const auto& entry : std::filesystem::directory_iterator(store() / "trials")) {
      std::istringstream lines(read_file(entry.path()));
      std::string spoiled;
      for (std::string line; std::getline(lines, line);) {
        TrialRecord record = parse_record(line, "line");
        spoil(record);
        spoiled += to_json_line(record) + "\n";
      }
      folder_.write("results/quick/trials/" + entry.path().filename().string(), spoiled);
    }
    return report_of(manifest_);
  }

  // A report without pictures, which says why on the terminal and not on the page.
  void expect_no_picture(const Output& output, const std::string& why) {
    EXPECT_EQ(output.exit, 0) << output.err;
    EXPECT_TRUE(contains(output.err, "warning: no pictures for 'results/quick': " + why)) << output.err;
    EXPECT_TRUE(contains(output.out, "annealing (baseline)")) << output.out;
    EXPECT_TRUE(contains(page(), "no pictures for &#39;results/quick&#39;: its study can&#39;t be drawn again here"));
    EXPECT_FALSE(contains(page(), "<svg class=\"plate"));
  }

  Folder folder_;
  Value manifest_;
};

TEST_F(HostileStore, HasPicturesWhileItIsNone) {
  EXPECT_TRUE(contains(page(), "<svg class=\"plate"));
  EXPECT_EQ(report_of(manifest_).exit, 0);
  EXPECT_TRUE(contains(page(), "<svg class=\"plate"));
}

constexpr const char* kPointsOf = R"([problem]
kind = "elastic"
body = { shape = "none" }
points = { file = "FILE" }
springs = { nearest = 3 }
)";

std::string points_of(const std::string& file) {
  std::string text = kPointsOf;
  return text.replace(text.find("FILE"), 4, file);
}

TEST_F(HostileStore, IsDrawnFromRegularFilesBelowTheStudyOnly) {
  for (const char* file : {"/etc/passwd", "/dev/zero", "../points.csv", "/dev/tty"})
    expect_no_picture(report_of_text(points_of(file)),
                      "the study names '" + std::string(file) + "', which is not below its folder '");
  ASSERT_EQ(::mkfifo((folder_.path() / "fifo").c_str(), 0600), 0);
  std::filesystem::create_symlink("/etc/passwd", folder_.path() / "link.csv");
  expect_no_picture(report_of_text(points_of("fifo")),
                    "the study names 'fifo', which is no regular file of its folder");
  expect_no_picture(report_of_text(points_of("missing.csv")),
                    "the study names 'missing.csv', which is no regular file");
  expect_no_picture(report_of_text(points_of("link.csv")), "the study names 'link.csv', which is not below its folder");
  // A file beside the study is read; what stands in it is quoted on the terminal at most.
  folder_.write("mine.csv", "secret,of,mine\n1,0,0\n");
  expect_no_picture(report_of_text(points_of("mine.csv")), "");
  EXPECT_FALSE(contains(page(), "secret"));
}

// Includes are those that the store holds, and no file: one that it lacks is not looked for.
TEST_F(HostileStore, IncludesNoFile) {
  folder_.write("mine.toml", "secret = \"of mine\"\n");
  const Output output = report_of_text("include = \"mine.toml\"\n[problem]\nkind = \"elastic\"\n");
  expect_no_picture(output, "");
  EXPECT_TRUE(contains(output.err, "mine.toml' is not stored")) << output.err;
  EXPECT_FALSE(contains(output.err, "secret")) << output.err;
}

// A folder of its own that leads elsewhere would have the figures replace what is there.
TEST_F(HostileStore, DoesNotLeadItsFiguresElsewhere) {
  std::filesystem::create_directory(folder_.path() / "elsewhere");
  std::filesystem::remove_all(store() / "figures");
  std::filesystem::create_directory_symlink(folder_.path() / "elsewhere", store() / "figures");
  const Output output = run(folder_, {"report", "results/quick"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_TRUE(contains(output.err, "cannot write into 'results/quick/figures': it is a link; remove it\n"))
      << output.err;
  EXPECT_TRUE(contains(output.out, "annealing (baseline)")) << output.out;  // the table is shown all the same
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / "elsewhere"));
}

// What stands where its report goes is replaced if it is a link, never followed, and refused if it is a pipe, without
// waiting for whoever reads from it.
TEST_F(HostileStore, IsNotWrittenThrough) {
  for (const std::string file : {"report.html", "summary.csv", "optimizers.csv", "budgets.csv"}) {
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"report", "results/quick"}, {"compare", "quick.toml"}}) {
      folder_.write("victim", "kept\n");
      std::filesystem::remove(store() / file);
      std::filesystem::create_symlink(folder_.path() / "victim", store() / file);
      const Output linked = run(folder_, command);
      EXPECT_EQ(linked.exit, 0) << linked.err;
      EXPECT_EQ(read_file(folder_.path() / "victim"), "kept\n");
      EXPECT_FALSE(std::filesystem::is_symlink(store() / file));
      EXPECT_GT(std::filesystem::file_size(store() / file), 100u);

      std::filesystem::remove(store() / file);
      ASSERT_EQ(::mkfifo((store() / file).c_str(), 0600), 0);
      const Output piped = run(folder_, command);
      EXPECT_EQ(piped.exit, 2);
      EXPECT_TRUE(contains(piped.err, "cannot write 'results/quick/" + file + "': it is no regular file; remove it\n"))
          << piped.err;
      EXPECT_TRUE(contains(piped.out, "annealing (baseline)")) << piped.out;  // the table is shown all the same
      std::filesystem::remove(store() / file);
    }
  }
}

TEST_F(HostileStore, IsNotDrawnWhereThatCostsMuch) {
  const auto began = std::chrono::steady_clock::now();
  expect_no_picture(report_of_text("[problem]\nkind = \"elastic\"\npoints = { counts = [1000, 1000] }\n"),
                    "1000000 nodes are too many for a picture");
  expect_no_picture(report_of_text("[problem]\nkind = \"elastic\"\npoints = { layout = \"voronoi\", total = 20000, "
                                   "iterations = 100000 }\n"),
                    "20000 nodes are too many for a picture");
  expect_no_picture(report_of_text("[problem]\nkind = \"elastic\"\npoints = { layout = \"voronoi\", total = 2000, "
                                   "iterations = 100000 }\n"),
                    "2000 points, iterated 100000 times, take too long for a picture");
  std::string deep = "a";
  for (int i = 0; i < 100000; ++i) deep += ".a";
  expect_no_picture(report_of_text(deep + " = 1\n"), "");
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began;
  EXPECT_LT(spent.count(), 15.0);  // each alone took minutes
}

// A comparison of a net from a file, which its folder may not have any more when the report is made again.
class StoreOfFiles : public HostileStore {
 protected:
  StoreOfFiles() {
    folder_.write("quick.toml", text());
    write_nodes("2,2");
    EXPECT_EQ(run(folder_, {"compare", "quick.toml", "--fresh"}).exit, 0);
  }

  static std::string text() {
    std::string text = kQuickStudy;
    return text.replace(
        text.find("points = { counts = [3, 3] }"), 28,
        "body = { size = [4, 4] }\npoints = { file = \"nodes.csv\" }\nsprings = { topology = \"nearest\", "
        "nearest = 5 }\nloads = { supports = \"minimal\" }");
  }
  void write_nodes(const std::string& middle) {
    folder_.write("nodes.csv", "x,y\n0,0\n2,0\n4,0\n0,2\n" + middle + "\n4,2\n0,4\n2,4\n4,4\n");
  }
  Output report() { return run(folder_, {"report", "results/quick"}); }
};

TEST_F(StoreOfFiles, HasPicturesWhileNothingChanges) {
  EXPECT_TRUE(contains(page(), "<svg class=\"plate"));
  EXPECT_EQ(report().exit, 0);
  EXPECT_TRUE(contains(page(), "<svg class=\"plate"));
}

TEST_F(StoreOfFiles, HasNoPicturesOfAnotherStudyInItsFolder) {
  folder_.write("quick.toml", text() + "# changed\n");
  expect_no_picture(report(), "the study names files, and '");
  EXPECT_TRUE(contains(report().err, "quick.toml' is not the study that the store was made of\n"));
  std::filesystem::remove(folder_.path() / "quick.toml");
  expect_no_picture(report(), "the study names files, and '");
}

// The study is as it was, the net is not: its springs number the same, or they don't.
TEST_F(StoreOfFiles, HasNoPicturesOfAnotherNet) {
  write_nodes("2.2,2.1");
  expect_no_picture(report(),
                    "the best trial of 'elastic' is of another system than the study and its files now: G was ");
  write_nodes("2,2\n1,1");
  const Output more = report();
  expect_no_picture(more, "the best trial of 'elastic' is of another system than the study and its files now: ");
  EXPECT_TRUE(contains(more.err, " coordinates, not ")) << more.err;
  write_nodes("2,2");
  EXPECT_EQ(report().exit, 0);
  EXPECT_TRUE(contains(page(), "<svg class=\"plate"));
}

TEST_F(HostileStore, WithoutItsStudyHasNoPictures) {
  Value bare;
  for (const auto& [key, value] : manifest_.table())
    if (key != "study") bare.set(key, value);
  expect_no_picture(report_of(bare), "its manifest has no study");
}

TEST_F(HostileStore, NamesTheKeyThatIsOfAnotherType) {
  Value manifest = manifest_;
  manifest.set("keys", Value::List{Value(1), Value(2)});
  const Output output = report_of(manifest);
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err,
            "nodal: 'results/quick/manifest.json' is not the manifest of a store: 'keys[0]' is an integer, not a text; "
            "choose another directory\n");
  manifest = manifest_;
  manifest.set("runs", Value::List{Value(1)});
  EXPECT_EQ(report_of(manifest).exit, 0);
}

// What is drawn: pictures, and the data of charts.
std::vector<std::string> charts(const std::string& page) {
  std::vector<std::string> found;
  for (const auto& [begin, end] :
       {std::pair("<svg", "</svg>"), std::pair("<script type=\"application/json\"", "</script>")})
    for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1))
      found.push_back(page.substr(at, page.find(end, at) - at));
  return found;
}

// No such counts and times exist, and no axis holds them: a row, and a chart without that line.
TEST_F(HostileStore, MayHoldAbsurdFigures) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  for (const double sign : {1.0, -1.0}) {
    const Output output = report_of_records([sign](TrialRecord& r) {
      const std::int64_t count = sign > 0.0 ? kMost : -kMost - 1;
      r.counts.evaluations = r.work.factorizations = count;
      r.seconds.total = sign * 1e308;
      r.work.flops = r.work.factorization_flops = sign * 1e308;
      for (TracePoint& p : r.trace) p = {count, sign * 1e308, count, sign * 1e308};
    });
    EXPECT_EQ(output.exit, 0) << output.err;
    EXPECT_GT(charts(page()).size(), 2u);
    for (const std::string& chart : charts(page()))
      for (const char* absurd : {"e+308", "e308"}) EXPECT_FALSE(contains(chart, absurd)) << chart;
  }
}

// What the terminal says of builds and disturbed trials stands on the page, too.
TEST_F(HostileStore, SaysOnThePageWhatItsTimesAreWorth) {
  const Output output = report_of_records([](TrialRecord& r) {
    if (!r.conditions) r.conditions.emplace();
    r.conditions->build = r.repeat == 0 ? "0123456789abcdef" : r.conditions->build;
    r.conditions->stopped = r.optimizer == "annealing";
    // The trials really ran, and a busy machine may have disturbed the others.
    r.seconds.cpu = r.seconds.total;
    r.conditions->preempted = r.conditions->waited = 0;
    r.conditions->pace = 1.0;
  });
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.err, "another build")) << output.err;
  EXPECT_TRUE(contains(page(), "another build"));
  for (const std::string& text : {output.out, page()}) {
    EXPECT_TRUE(contains(text, "annealing (baseline) †")) << text;
    EXPECT_TRUE(contains(text, "† 2 of 4 trials did not have a processor core to themselves")) << text;
  }
}

TEST_F(HostileStore, MayHoldTheSmallestNumbers) {
  const Output output = report_of_records([](TrialRecord& r) {
    for (PointSummary* point : {&r.start, &r.best->summary}) *point = {5e-324, 5e-324, 5e-324};
    for (TracePoint& p : r.trace) p.quality = p.seconds = 5e-324;
  });
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.out, "4.941e-324")) << output.out;
}

}  // namespace
}  // namespace nodal::program
