// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure12.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <nodal/analysis.h>

#include "../../support/components.h"

namespace nodal::paper {

namespace {

constexpr const char* kScene = NODAL_SOURCE_DIR "/bench/scenes/paper/fig12.toml";

std::string scene_text() {
  std::ifstream in(kScene);
  if (!in) throw std::runtime_error(std::string("can't read ") + kScene);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// All of them, and there must be so many: a scene written in another way must not pass unchanged.
void replace(std::string& text, const std::string& from, const std::string& to, std::size_t count) {
  std::size_t found = 0;
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()), ++found)
    text.replace(at, from.size(), to);
  if (found != count) throw std::runtime_error(std::string(kScene) + " has no " + from);
}

double median(std::vector<double> values) {
  const auto found = quartiles(std::move(values));
  if (!found) throw std::runtime_error("no trial has a best point");
  return found->median;
}

}  // namespace

const std::vector<int>& iteration_counts() {
  static const std::vector<int> counts = {0, 1, 5, 15, 50};
  return counts;
}

Study make_study(int seed, const Figure12& figure) {
  std::string text = scene_text();
  const std::size_t problems = iteration_counts().size();
  replace(text, " seed = 1,", " seed = " + std::to_string(seed) + ",", problems);
  replace(text, "springs = { topology = \"delaunay\", initial = \"area\" }",
          "material = { poisson = " + figure.poisson + " }\nsprings = { topology = \"" + figure.topology +
              "\", initial = " + figure.initial + " }",
          problems);
  replace(text, "evaluations = 50000", "evaluations = " + std::to_string(figure.evaluations), 1);
  return parse_study(text, kScene, components());
}

std::vector<TrialRecord> fits(int iterations, Fit fit, const Figure12& figure) {
  std::vector<TrialRecord> records;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Study study = make_study(seed, figure);
    const auto problem = std::ranges::find_if(study.problems, [&](const StudyProblem& p) {
      return p.options.table("points").integer("iterations") == iterations;
    });
    if (problem == study.problems.end()) throw std::runtime_error("no problem of so many iterations");
    records.push_back(run_trial(study,
                                {.problem = static_cast<std::size_t>(problem - study.problems.begin()),
                                 .optimizer = static_cast<std::size_t>(fit)},
                                components()));
  }
  return records;
}

double median_start_error(const std::vector<TrialRecord>& records) {
  std::vector<double> errors;
  for (const TrialRecord& record : records) errors.push_back(record.start.relative_error.value());
  return median(std::move(errors));
}

double median_best_error(const std::vector<TrialRecord>& records) {
  std::vector<double> errors;
  for (const TrialRecord& record : records) errors.push_back(record.best.value().summary.relative_error.value());
  return median(std::move(errors));
}

}  // namespace nodal::paper
