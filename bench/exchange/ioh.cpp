// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/value.h>

#include "format.h"

namespace nodal::exchange {

namespace {

// Of the program whose files these are like: IOHanalyzer reads those from 0.3.3 on in the way described here.
constexpr std::string_view kVersion = "0.3.23";

constexpr std::array<std::string_view, 5> kColumns = {"evaluations", "raw_y", "transformed_y", "seconds",
                                                      "factorizations"};

std::string quoted(const std::string& text) { return to_json(Value(text)); }

// "1.0": IOHinspector takes the type of a number from how it is written, and it must be one for all files.
std::string real(double number) { return to_json(Value(number)); }

std::string data_of(const Function& function) {
  std::string text;
  for (const Run& run : function.runs) {
    text += fmt::format("{}\n", fmt::join(kColumns, " "));
    for (const RunPoint& point : run.points)
      fmt::format_to(std::back_inserter(text), "{} {} {} {} {}\n", point.evaluation, point.precision, point.quality,
                     point.seconds, point.factorizations);
  }
  return text;
}

std::string run_text(const Run& run) {
  const RunPoint& best = *std::ranges::min_element(run.points, {}, &RunPoint::precision);
  Value::List x(run.x.begin(), run.x.end());
  return fmt::format(
      R"({{"instance": {}, "evals": {}, "best": {{"evals": {}, "y": {}, "x": {}}}, "total_seconds": {}}})",
      run.instance, run.evaluations, best.evaluation, real(best.precision), to_json(Value(std::move(x))),
      real(run.seconds));
}

std::string index_of(const Algorithm& algorithm, const Function& function, const std::string& data) {
  std::string runs;
  for (const Run& run : function.runs) runs += (runs.empty() ? "\n\t\t\t" : ",\n\t\t\t") + run_text(run);
  return fmt::format(
      "{{\n\t\"version\": \"{}\",\n\t\"suite\": \"nodal\",\n\t\"function_id\": {},\n\t\"function_name\": {},\n"
      "\t\"maximization\": false,\n\t\"algorithm\": {{\"name\": {}, \"info\": {}}},\n"
      "\t\"experiment_attributes\": [{{\"best_quality\": \"{}\"}}],\n\t\"run_attributes\": [\"total_seconds\"],\n"
      "\t\"attributes\": [\"{}\"],\n\t\"scenarios\": [\n"
      "\t\t{{\"dimension\": {},\n\t\t\"path\": \"{}\",\n\t\t\"runs\": [{}\n\t\t]}}\n\t]\n}}\n",
      kVersion, function.id, quoted(function.name), quoted(algorithm.name), quoted(algorithm.method),
      real(function.best_quality), fmt::join(kColumns, "\", \""), function.dimension, data, runs);
}

}  // namespace

void write_ioh(const Experiment& experiment, const Sink& sink) {
  for (const Algorithm& algorithm : experiment.algorithms)
    for (const Function& function : algorithm.functions) {
      const std::filesystem::path folder = algorithm.folder;
      const std::string name = fmt::format("f{}_{}", function.id, file_name_of(function.name));
      const std::string data = fmt::format("data_{}/IOHprofiler_f{}_DIM{}.dat", name, function.id, function.dimension);
      sink(folder / data, data_of(function));
      sink(folder / fmt::format("IOHprofiler_{}.json", name), index_of(algorithm, function, data));
    }
}

}  // namespace nodal::exchange
