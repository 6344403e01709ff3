// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "format.h"

namespace nodal::exchange {

namespace {

// cocopp knows its own suites only; of these "bbob" asks for nothing but one objective without constraints.
constexpr std::string_view kSuite = "bbob";
constexpr double kFinalPrecision = 1e-8;
// Of the times at which the .tdat file has a line: COCO's own choice.
constexpr int kTimesPerDecade = 20;

// What a quoted text of an .info file can't hold, and commas, which IOHanalyzer takes for the end of any value.
std::string quotable(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool awkward = static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\'' || c == '"' || c == '\\';
    result += awkward ? '_' : c == ',' ? ';' : c;
  }
  return result;
}

std::string run_header(const Function& function) {
  return fmt::format(
      "% f evaluations | g evaluations | best noise-free fitness - {} ({:13.12e}) + sum g_i+ | measured fitness | best "
      "measured fitness or single-digit g-values | x1 | x2...\n",
      function.provisional ? "Fref" : "Fopt", function.best_quality);
}

// The measured fitness of a line is the best so far: what else was measured is not stored.
void add_line(std::string& text, std::int64_t evaluation, const RunPoint& best) {
  fmt::format_to(std::back_inserter(text), "{} 0 {:+10.9e} {:+10.9e} {:+10.9e}\n", evaluation, best.precision,
                 best.quality, best.quality);
}

// Every improvement, and the last evaluation.
std::string improvements(const Function& function) {
  std::string text;
  for (const Run& run : function.runs) {
    text += run_header(function);
    for (const RunPoint& point : run.points) add_line(text, point.evaluation, point);
  }
  return text;
}

// The best so far at evaluations evenly spaced in the logarithm, and at the last.
std::string at_times(const Function& function) {
  std::string text;
  for (const Run& run : function.runs) {
    text += run_header(function);
    std::size_t at = 0;
    std::int64_t written = 0;
    for (int k = 0; written < run.evaluations; ++k) {
      const double time = std::floor(std::pow(10.0, static_cast<double>(k) / kTimesPerDecade));
      const std::int64_t now =
          time < static_cast<double>(run.evaluations) ? static_cast<std::int64_t>(time) : run.evaluations;
      if (now == written) continue;
      while (at + 1 < run.points.size() && run.points[at + 1].evaluation <= now) ++at;
      add_line(text, now, run.points[at]);
      written = now;
    }
  }
  return text;
}

std::string index_entry(const Algorithm& algorithm, const Function& function, const std::string& data) {
  std::string text = fmt::format(
      "suite = '{}', funcId = {}, DIM = {}, Precision = {:.3e}, algId = '{}', logger = 'bbob', data_format = "
      "'bbob-new2'\n% {} on {}\n{}.dat",
      kSuite, function.id, function.dimension, kFinalPrecision, quotable(algorithm.name), quotable(algorithm.method),
      quotable(function.name), data);
  for (const Run& run : function.runs)
    text += fmt::format(", {}:{}|{:.1e}", run.instance, run.evaluations, run.points.back().precision);
  return text + "\n";
}

}  // namespace

void write_coco(const Experiment& experiment, const Sink& sink) {
  for (const Algorithm& algorithm : experiment.algorithms)
    for (const Function& function : algorithm.functions) {
      const std::filesystem::path folder = algorithm.folder;
      const std::string data = fmt::format("data_f{0}/bbobexp_f{0}_DIM{1}", function.id, function.dimension);
      sink(folder / (data + ".dat"), improvements(function));
      sink(folder / (data + ".tdat"), at_times(function));
      sink(folder / fmt::format("bbobexp_f{}.info", function.id), index_entry(algorithm, function, data));
    }
}

}  // namespace nodal::exchange
