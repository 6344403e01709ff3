// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/best_known.h"

#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/evaluator.h>
#include <nodal/exhibit.h>
#include <nodal/shown.h>

namespace nodal {

namespace {

std::vector<double> read_point(const Problem& problem, const std::filesystem::path& file, const Source& named) {
  const std::shared_ptr<const Exhibit> exhibit = exhibit_of(problem);
  std::optional<std::vector<double>> x;
  try {
    x = exhibit->point(exhibit->read(file));
  } catch (const Refusal& refusal) {
    throw InputError(named, fmt::format("{}; give the 'quality' instead", refusal.what()));
  } catch (const InputError& error) {
    throw InputError(named, error.what());
  }
  if (!x)
    throw InputError(named,
                     fmt::format("'{}' is not a system that this problem can reach: it is outside of the bounds, "
                                 "or parts that move together differ",
                                 shown(file.string())));
  return std::move(*x);
}

}  // namespace

KnownOptimum read_best_known(const Options& known, const Problem& problem, const std::filesystem::path& folder) {
  if (known.has("quality") == known.has("file"))
    throw InputError(known.values().source,
                     "'best_known' has either a 'quality', or a 'file' with the system that has it");
  if (known.has("quality")) return {known.number("quality"), known.text("origin"), {}};
  const Source& named = known.at("file").source;
  std::vector<double> x = read_point(problem, folder / known.text("file"), named);
  const Evaluation there = problem.make_evaluator()->audit(x);
  if (!there.ok() || !std::isfinite(there.cost))
    throw InputError(
        named, fmt::format("the system of '{}' has no quality: {}", shown(known.text("file")), in_words(there.status)));
  return {problem.quality(there.cost), known.text("origin"), std::move(x)};
}

void replace_best_known(Value& problem, std::string_view later) {
  if (!problem.is_table() || (later != "quality" && later != "file")) return;
  const std::string_view other = later == "file" ? "quality" : "file";
  for (auto& [key, known] : problem.table())
    if (key == "best_known" && known.is_table())
      std::erase_if(known.table(), [other](const auto& entry) { return entry.first == other; });
}

}  // namespace nodal
