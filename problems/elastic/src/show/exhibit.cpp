// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/exhibit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <nodal/elastic/determination.h>
#include <nodal/elastic/extended_equilibrium.h>
#include <nodal/elastic/pruning.h>

#include "export/system_format.h"
#include "show/drawing_cost.h"
#include "show/make_picture.h"
#include "show/picture_svg.h"
#include "show/pictures_html.h"
#include "show/springs_html.h"
#include "show/state.h"
#include "show/style.h"

namespace nodal::elastic::show {

namespace {

// Solved once, shown in several ways.
class SolvedSystem final : public ShownSystem {
 public:
  SolvedSystem(const ElasticProblem& problem, std::string label, std::span<const double> stiffness)
      : problem_(problem),
        label_(std::move(label)),
        stiffness_(stiffness.begin(), stiffness.end()),
        state_(problem.solve(stiffness)) {}

  [[nodiscard]] std::string failure() const override {
    if (state_.status == Status::ok) return {};
    return fmt::format("{}: {}", to_string(state_.status), state_.message);
  }
  [[nodiscard]] Value data() const override { return state_json(label_, problem_, stiffness_, state_); }
  [[nodiscard]] std::string text() const override { return state_text(label_, problem_, stiffness_, state_); }
  [[nodiscard]] std::string picture(const std::string& title) const override {
    return picture_svg(make_picture(problem_, stiffness_, state_, label_, title));
  }

 private:
  const ElasticProblem& problem_;
  std::string label_;
  std::vector<double> stiffness_;
  State state_;
};

// What is fitted better than the reference is known; empty where that isn't so.
std::string below_reference_error(const ElasticProblem& problem, std::span<const double> stiffness) {
  if (!problem.reference_error()) return {};
  const State state = problem.solve(stiffness);
  if (state.status != Status::ok || state.relative_error >= *problem.reference_error()) return {};
  return fmt::format(
      "the relative error, {:.2g}, is below the estimated error of the finite elements that it is told against, "
      "{:.2g}: "
      "it is no result; reference = {{ tolerance = … }} asks for finer ones",
      state.relative_error, *problem.reference_error());
}

}  // namespace

std::vector<double> ElasticExhibit::values(std::span<const double> x) const { return problem_.stiffness(x); }

std::vector<double> ElasticExhibit::start() const { return problem_.start_stiffness(); }

std::vector<double> ElasticExhibit::read(const std::filesystem::path& file) const {
  InputFiles files;
  return read_back(system_formats(), files, file, problem_.net());
}

std::optional<std::vector<double>> ElasticExhibit::point(std::span<const double> stiffness) const {
  constexpr double kSame = 1e-5;  // people write six digits: half a unit of the last is at most 5e-6
  const Space& space = problem_.space();
  std::vector<double> x(space.size());
  problem_.parameters().coordinates(stiffness, x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double within = std::clamp(x[i], space.lower()[i], space.upper()[i]);
    if (!(std::abs(within - x[i]) <= kSame)) return std::nullopt;
    x[i] = within;
  }
  const std::vector<double> reached = problem_.stiffness(x);
  for (std::size_t e = 0; e < reached.size(); ++e)
    if (!(std::abs(reached[e] - stiffness[e]) <= kSame * stiffness[e])) return std::nullopt;
  return x;
}

std::optional<double> ElasticExhibit::exact_quality(std::span<const double> stiffness) const {
  constexpr double kMostOperations = 1e6;  // 0.3 s
  const Scene& scene = problem_.scene();
  if (!scene.has_reference || extended_operations(scene) > kMostOperations) return std::nullopt;
  const State state = problem_.solve(stiffness);
  const std::optional<ExtendedState> exact = solve_extended(scene, stiffness);
  if (!exact || state.status != Status::ok) return std::nullopt;
  return problem_.quality(exact->cost + (state.prior ? state.prior->cost : 0.0));
}

std::unique_ptr<ShownSystem> ElasticExhibit::show(const std::string& label, std::span<const double> stiffness) const {
  return std::make_unique<SolvedSystem>(problem_, label, stiffness);
}

std::vector<std::string> ElasticExhibit::notes() const { return problem_.account().findings(); }

std::vector<std::string> ElasticExhibit::notes_at(std::span<const double> stiffness) const {
  std::vector<std::string> notes;
  for (std::string note :
       {describe(determine(problem_, stiffness), problem_), below_reference_error(problem_, stiffness)})
    if (!note.empty()) notes.push_back(std::move(note));
  return notes;
}

std::vector<std::string> ElasticExhibit::proposals() const { return propose(problem_); }

std::vector<std::string> ElasticExhibit::remedies() const {
  const Scene& scene = problem_.scene();
  std::vector<std::string> remedies = {"more loads to fit"};
  if (!scene.prior) remedies.emplace_back("a prior (prior = { weight = 1e-4 })");
  if (scene.stiffness_bounds.shared())
    remedies.emplace_back("bounds around the start (springs = { bounds = { around = \"start\", factor = 4 } })");
  return remedies;
}

ReportPart ElasticExhibit::report(const std::string& label, std::span<const LabelledPoint> points) const {
  if (problem_.net().springs.size() > kMostPicturedSprings) return {};
  std::vector<Picture> pictures;
  const bool all = problem_.net().springs.size() <= kMostToldSprings;
  for (const LabelledPoint& point : points.first(all ? points.size() : std::min<std::size_t>(points.size(), 2)))
    if (auto picture = make_picture(problem_, point.x, label, point.label)) pictures.push_back(std::move(*picture));
  const bool told = pictures.size() > 1 && problem_.net().springs.size() <= kMostToldSprings;
  return {pictures_html(pictures), std::string(picture_css()) + std::string(pictures_css()),
          std::string(told ? springs_js() : std::string_view())};
}

std::vector<ExportFormat> ElasticExhibit::formats() const {
  std::vector<ExportFormat> formats;
  for (const SystemFormat* format : system_formats())
    formats.push_back(
        {std::string(format->name), std::string(format->extension), std::string(format->summary), format->lacking()});
  return formats;
}

std::string ElasticExhibit::write(const ExportFormat& format, std::span<const double> stiffness) const {
  const SystemFormat* known = find_named(system_formats(), format.name);
  if (!known) throw std::logic_error("no format of the elastic problem is called '" + format.name + "'");
  return known->write(problem_, {stiffness.begin(), stiffness.end()});
}

Reduced ElasticExhibit::reduce(std::span<const double> stiffness, double most_loss) const {
  const Pruned pruned = prune(problem_, stiffness, most_loss);
  Reduced reduced{nullptr, {}, describe(pruned)};
  if (pruned.removed.empty()) return reduced;
  reduced.problem = pruned.problem;
  reduced.values = pruned.stiffness;
  return reduced;
}

}  // namespace nodal::elastic::show
