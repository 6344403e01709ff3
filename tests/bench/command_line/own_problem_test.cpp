// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of problem that shows itself in every way there is: the program, which knows nothing of it, shows it so.
#include <gtest/gtest.h>

#include <cmath>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include <nodal/command_line.h>
#include <nodal/components.h>
#include <nodal/exhibit.h>

#include "program.h"

namespace nodal::program {
namespace {

// How far a beam sags that is x thick: the cost is (x − 2)²/2.
class BeamEvaluator final : public Evaluator {
 public:
  Evaluation value(std::span<const double> x) override {
    thickness_ = x[0];
    return {Status::ok, 0.5 * (x[0] - 2.0) * (x[0] - 2.0)};
  }
  [[nodiscard]] Health health() const override {
    Health health;
    health.findings = {{"sag", 1.0 / thickness_}};
    return health;
  }
  // A beam of 1.5 has the weight that was asked for, and the thicker one is, the worse it sounds.
  [[nodiscard]] Status held_out_errors(std::span<const double> x, std::span<double> errors) override {
    errors[0] = std::abs(x[0] - 1.5);
    errors[1] = x[0] * x[0];
    return Status::ok;
  }

 private:
  double thickness_ = 1.0;
};

class ShownBeam final : public ShownSystem {
 public:
  ShownBeam(std::string label, double thickness) : label_(std::move(label)), thickness_(thickness) {}
  [[nodiscard]] std::string failure() const override { return thickness_ > 0.0 ? "" : "a beam without thickness"; }
  [[nodiscard]] Value data() const override { return Value::Table{{"beam", label_}, {"thickness", thickness_}}; }
  [[nodiscard]] std::string text() const override {
    return label_ + " is so thick: " + std::to_string(thickness_) + "\n";
  }
  [[nodiscard]] std::string picture(const std::string& title) const override { return "<svg>" + title + "</svg>\n"; }

 private:
  std::string label_;
  double thickness_;
};

class BeamExhibit final : public PlainExhibit {
 public:
  using PlainExhibit::PlainExhibit;
  [[nodiscard]] std::vector<double> read(const std::filesystem::path& file) const override {
    return {std::stod(read_file(file))};
  }
  [[nodiscard]] std::unique_ptr<ShownSystem> show(const std::string& label,
                                                  std::span<const double> values) const override {
    return std::make_unique<ShownBeam>(label, values[0]);
  }
  [[nodiscard]] bool draws() const override { return true; }
  [[nodiscard]] std::vector<std::string> notes() const override { return {"beams are straight"}; }
  [[nodiscard]] std::vector<std::string> notes_at(std::span<const double> /*values*/) const override {
    return {"nothing is left open"};
  }
  [[nodiscard]] ReportPart report(const std::string& label, std::span<const LabelledPoint> points) const override {
    return {"<b>" + label + " from " + points.front().label + "</b>", ".beam { }\n", "draw(beam);\n"};
  }
  [[nodiscard]] std::vector<ExportFormat> formats() const override {
    return {{"words", ".txt", "words"}, {"steel", ".step", "STEP", "a foundry"}};
  }
  [[nodiscard]] std::string write(const ExportFormat& format, std::span<const double> values) const override {
    return format.name + ": " + std::to_string(values[0]);
  }
  [[nodiscard]] bool reduces() const override { return true; }
  [[nodiscard]] Reduced reduce(std::span<const double> /*values*/, double /*most_loss*/) const override {
    return {nullptr, {}, "a beam is one piece"};
  }
};

class BeamProblem final : public Problem {
 public:
  [[nodiscard]] const Space& space() const override { return space_; }
  [[nodiscard]] Abilities abilities() const override { return {}; }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override { return std::make_unique<BeamEvaluator>(); }
  [[nodiscard]] const Exhibit* exhibit() const override { return &exhibit_; }
  [[nodiscard]] std::vector<std::string> held_out() const override { return {"weight", "sound"}; }

 private:
  Space space_{{{"thickness", 0.5, 4.0, 1.0}}};
  BeamExhibit exhibit_{*this};
};

ProblemDescription beam() {
  return {.kind = "beam",
          .make = [](const Options&, const ProblemContext&) { return std::make_shared<BeamProblem>(); },
          .quality_name = "B",
          .findings = {{.name = "sag", .title = "sag", .unit = "m", .tabled = true}},
          .commands = {{.name = "bend",
                        .summary = "Bends a beam",
                        .positional = "beam",
                        .options = {{.name = "beam", .type = OptionType::text, .required = true, .unit = "BEAM"},
                                    {.name = "times", .type = OptionType::integer, .default_value = 1, .minimum = 1},
                                    {.name = "loud", .type = OptionType::boolean, .default_value = false}},
                        .run =
                            [](const Options& o, const CommandContext& context) {
                              context.out << o.text("beam") << " bent " << o.integer("times") << " times"
                                          << (o.boolean("loud") ? "!" : "") << '\n';
                              return o.integer("times") > 3 ? 1 : 0;
                            }}},
          .listings = {{"beams", {"oak", "ash"}}}};
}

class OwnProblem : public testing::Test {
 protected:
  OwnProblem() {
    folder_.write("beam.toml",
                  "[study]\nname = \"beams\"\nrepeats = 1\n[budget]\nevaluations = 30\n[problem]\nkind = \"beam\"\n"
                  "[[optimizer]]\nuse = \"random-search\"\n");
  }

  // The program with one kind of problem more, in a process of its own.
  Output call(const std::vector<std::string>& arguments) const {
    std::fflush(nullptr);  // what waits there is the parent's
    const pid_t child = ::fork();
    if (child == 0) {
      if (::chdir(folder_.path().c_str()) != 0) ::_exit(126);
      ::dup2(::open("stdout", O_CREAT | O_TRUNC | O_WRONLY, 0666), STDOUT_FILENO);
      ::dup2(::open("stderr", O_CREAT | O_TRUNC | O_WRONLY, 0666), STDERR_FILENO);
      Registry registry;
      register_components(registry);
      registry.add(beam());
      std::vector<const char*> words = {"nodal"};
      for (const std::string& argument : arguments) words.push_back(argument.c_str());
      ::_exit(command_line(registry, static_cast<int>(words.size()), words.data()));
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WEXITSTATUS(status), read_file(folder_.path() / "stdout"), read_file(folder_.path() / "stderr")};
  }

  Folder folder_;
};

TEST_F(OwnProblem, IsEvaluatedAndDrawn) {
  Output output = call({"evaluate", "beam.toml", "--picture", "b.svg"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_EQ(output.out, "beam is so thick: 1.000000\n");
  EXPECT_EQ(output.err, "note: beams are straight\nwritten: b.svg\n");
  EXPECT_EQ(read_file(folder_.path() / "b.svg"), "<svg>start</svg>\n");
  folder_.write("thick.txt", "3.5");
  EXPECT_EQ(call({"evaluate", "beam.toml", "--values", "thick.txt", "--json"}).out,
            "{\"beam\":\"beam\",\"thickness\":3.5}\n");
  folder_.write("thick.txt", "-1");
  output = call({"evaluate", "beam.toml", "--values", "thick.txt"});
  EXPECT_EQ(output.exit, 1);
  EXPECT_EQ(output.err, "nodal: beam: a beam without thickness\n");
}

TEST_F(OwnProblem, IsFittedPrunedAndExported) {
  const Output output = call({"fit", "beam.toml", "--with", "random-search", "--prune", "--export", "f.txt"});
  EXPECT_EQ(output.exit, 0) << output.err;
  for (const char* said : {"note: beams are straight\n", "; sag 0.", " m; no coordinate at a bound\n",
                           "note: nothing is left open\n", "pruned: a beam is one piece\n", "written: f.txt\n"})
    EXPECT_TRUE(contains(output.err, said)) << said << "in\n" << output.err;
  EXPECT_TRUE(read_file(folder_.path() / "f.txt").starts_with("words: "));
  EXPECT_TRUE(contains(call({"fit", "beam.toml", "--export", "f.json"}).err,
                       "'f.json' doesn't end in .txt or .step; what is fitted is written as words or STEP"));
  EXPECT_TRUE(
      contains(call({"fit", "beam.toml", "--export", "f.step"}).err, "writing 'f.step' as STEP needs a foundry"));
}

TEST_F(OwnProblem, IsInTableCsvAndPage) {
  const Output output = call({"compare", "beam.toml", "--out", "store"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.out, "beam: B at the start 0.5000; B* = ")) << output.out;
  EXPECT_TRUE(contains(output.out, "   sag")) << output.out;
  EXPECT_TRUE(contains(output.out, "   [m]")) << output.out;
  EXPECT_TRUE(contains(read_file(folder_.path() / "store" / "optimizers.csv"),
                       ",sag_lower,sag_median,sag_upper,unseen_lower,unseen_median,unseen_upper\n"));
  EXPECT_EQ(call({"report", "store"}).exit, 0);  // from the store alone
  const std::string page = read_file(folder_.path() / "store" / "report.html");
  for (const char* part : {"<b>beam from start</b>", ".beam { }", "draw(beam);", "gap to B*"})
    EXPECT_TRUE(contains(page, part)) << part;
}

TEST_F(OwnProblem, HasACommandAndAList) {
  EXPECT_EQ(call({"bend", "oak"}).out, "oak bent 1 times\n");
  EXPECT_EQ(call({"bend", "oak", "--times", "3", "--loud"}).out, "oak bent 3 times!\n");
  EXPECT_EQ(call({"bend", "oak", "--times", "4"}).exit, 1);
  const Output wrong = call({"bend", "oak", "--times", "0"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_EQ(wrong.err, "nodal: --times: 'times' of nodal bend is 0; allowed: times ≥ 1\n");
  EXPECT_EQ(call({"bend"}).exit, 2);
  EXPECT_EQ(call({"list", "beams"}).out, "oak\nash\n");
}

TEST_F(OwnProblem, IsExplained) {
  EXPECT_TRUE(contains(call({"explain", "beam.toml"}).out, "  note: nothing is left open\n"));
}

TEST_F(OwnProblem, IsToldOfWhatItHoldsOut) {
  Output output = call({"fit", "beam.toml", "--with", "random-search", "--export", "f.txt"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.err, "; of what was never fitted: weight 0.")) << output.err;
  EXPECT_TRUE(contains(output.err, " (at the start 0.7906); ")) << output.err;  // √((0.5² + 1²)/2)
  EXPECT_TRUE(contains(output.err, "\nnote: unseen error ")) << output.err;
  EXPECT_TRUE(contains(output.err, "above the start's 0.791")) << output.err;
  output = call({"fit", "beam.toml", "--with", "random-search", "--validate", "--export", "f.txt"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.err, "\nchosen by weight: the point of evaluation ")) << output.err;
  EXPECT_TRUE(contains(output.err, "; of what was never fitted: sound ")) << output.err;

  ASSERT_EQ(call({"compare", "beam.toml"}).exit, 0);
  output = call({"report", "results/beams"});
  EXPECT_TRUE(contains(output.out, "unseen")) << output.out;
  EXPECT_TRUE(contains(output.out, "Worse than their starts in what is held out: random-search (")) << output.out;
  EXPECT_TRUE(contains(read_file(folder_.path() / "results/beams/report.html"), "id=\"unseen-0\""));
  EXPECT_TRUE(contains(read_file(folder_.path() / "results/beams/optimizers.csv"), "unseen_median"));
}

}  // namespace
}  // namespace nodal::program
