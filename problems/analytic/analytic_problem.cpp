// SPDX-License-Identifier: GPL-3.0-or-later
#include "analytic_problem.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "evaluators.h"

namespace nodal::analytic {

namespace {

// Jacobians are dense for those who ask for them: 10^4 coordinates make 800 MB.
constexpr double kMostCoordinates = 1e4;

// How far inside a customary start is moved that the bounds leave outside: this share of the box. Methods that start on
// a bound can stick to it.
constexpr double kJustInside = 1e-6;

using Bounds = std::array<double, 2>;

// Where a function has no customary start: a point of the box's middle 80 %, each coordinate elsewhere, so that no
// symmetry is mistaken for skill. frac(i φ) fills [0, 1) evenly, φ the golden ratio.
double default_start(std::size_t i, const Bounds& box) {
  constexpr double kGoldenRatio = 1.6180339887498949;
  const double turns = static_cast<double>(i + 1) * kGoldenRatio;
  return box[0] + (0.1 + 0.8 * (turns - std::floor(turns))) * (box[1] - box[0]);
}

std::size_t read_dimension(const Function& function, const Options& options) {
  const auto dimension = static_cast<std::size_t>(options.integer("dimension"));
  if (dimension % function.multiple != 0)
    throw InputError(options.at("dimension").source, fmt::format("'dimension' is {}; {} needs a multiple of {}",
                                                                 dimension, function.kind, function.multiple));
  return dimension;
}

Bounds read_bounds(const Options& options) {
  const std::vector<double> bounds = options.numbers("bounds");
  // A width that overflows is no box to draw points from.
  if (!(bounds[0] < bounds[1]) || !std::isfinite(bounds[1] - bounds[0]))
    throw InputError(
        options.at("bounds").source,
        fmt::format("'bounds' is [{}, {}]; it must be [lower, upper] with lower < upper", bounds[0], bounds[1]));
  return {bounds[0], bounds[1]};
}

std::vector<double> read_start(const Options& options, std::size_t dimension, const Bounds& box) {
  std::vector<double> start = options.numbers("start");
  const Source& source = options.at("start").source;
  if (start.size() != dimension)
    throw InputError(
        source, fmt::format("'start' has {} entries; with dimension {} it must have as many", start.size(), dimension));
  for (std::size_t i = 0; i < dimension; ++i)
    if (start[i] < box[0] || start[i] > box[1])
      throw InputError(
          source, fmt::format("'start' is {} in x{}, outside the bounds [{}, {}]", start[i], i + 1, box[0], box[1]));
  return start;
}

}  // namespace

OptionSchema function_schema(const Function& function) {
  const std::string multiple = function.multiple > 1 ? fmt::format(", a multiple of {}", function.multiple) : "";
  return {
      {.name = "dimension",
       .type = OptionType::integer,
       .default_value = static_cast<std::int64_t>(function.dimension),
       .minimum = static_cast<double>(function.least_dimension),
       .maximum = kMostCoordinates,
       .help = "how many coordinates" + multiple},
      {.name = "bounds",
       .type = OptionType::number_list,
       .default_value = Value(Value::List{Value(function.lower), Value(function.upper)}),
       .length = 2,
       .help = "lower and upper bound of every coordinate; the customary box by default"},
      {.name = "start",
       .type = OptionType::number_list,
       .default_text = function.start ? "the customary start" : "a point without symmetry in the middle of the box",
       .help = "where trials start, one entry per coordinate"},
  };
}

AnalyticProblem::AnalyticProblem(const Function& function, const Options& options) : function_(function) {
  const std::size_t dimension = read_dimension(function, options);
  const Bounds box = read_bounds(options);
  const double margin = kJustInside * (box[1] - box[0]);
  std::vector<double> start(dimension);
  if (options.has("start")) {
    start = read_start(options, dimension, box);
  } else {
    for (std::size_t i = 0; i < dimension; ++i) {
      start[i] = function.start ? function.start(i) : default_start(i, box);
      if (box[0] <= start[i] && start[i] <= box[1]) continue;
      start[i] = std::clamp(start[i], box[0] + margin, box[1] - margin);
      ++moved_starts_;
    }
  }
  std::vector<Coordinate> coordinates;
  for (std::size_t i = 0; i < dimension; ++i)
    coordinates.push_back({fmt::format("x{}", i + 1), box[0], box[1], start[i]});
  space_ = Space(coordinates);
}

Abilities AnalyticProblem::abilities() const {
  const bool residuals = function_.has_residuals();
  return {.gradient = true, .residuals = residuals, .jacobian_products = residuals, .moves = false};
}

std::size_t AnalyticProblem::residual_count() const {
  return function_.has_residuals() ? function_.least_squares.residual_count(space_.size()) : 0;
}

std::unique_ptr<Evaluator> AnalyticProblem::make_evaluator() const {
  if (function_.has_residuals()) return std::make_unique<LeastSquaresEvaluator>(function_.least_squares, space_.size());
  return std::make_unique<SmoothEvaluator>(function_.smooth, space_.size());
}

std::optional<KnownOptimum> AnalyticProblem::known_optimum() const {
  std::vector<double> x(space_.size(), function_.optimum);
  if (!space_.contains(x)) return std::nullopt;
  return KnownOptimum{0.0, "the function is nowhere below 0", std::move(x)};
}

std::vector<Stage> AnalyticProblem::stages() const {
  const bool residuals = function_.has_residuals();
  const std::string why_not = "the function is no sum of squares";
  return {
      {"value", true, fmt::format("{}, {} coordinate{}", function_.kind, space_.size(), space_.size() == 1 ? "" : "s")},
      {"gradient", true, "closed form"},
      {"residuals and Jacobian", residuals, residuals ? fmt::format("{} residuals", residual_count()) : why_not},
      {"Jacobian products", residuals, residuals ? "from the Jacobian's nonzeros" : why_not},
      {"moves", false, "proposals are full evaluations"},
  };
}

std::vector<std::string> AnalyticProblem::remarks() const {
  std::vector<std::string> remarks;
  if (!known_optimum())
    remarks.push_back(
        fmt::format("the bounds leave the function's optimum ({} in every coordinate) outside: none is claimed",
                    function_.optimum));
  if (moved_starts_ > 0)
    remarks.push_back(fmt::format("the start of {} of {} coordinates was outside the bounds and moved just inside",
                                  moved_starts_, space_.size()));
  return remarks;
}

}  // namespace nodal::analytic
