// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/exhibit.h>

#include <fmt/format.h>

namespace nodal {

namespace {

class PlainSystem final : public ShownSystem {
 public:
  PlainSystem(const Problem& problem, std::string label, std::span<const double> x)
      : problem_(problem), label_(std::move(label)), seen_(problem.make_evaluator()->audit(x)) {}

  [[nodiscard]] std::string failure() const override {
    return seen_.ok() ? std::string() : fmt::format("the start can't be evaluated: {}", in_words(seen_.status));
  }

  [[nodiscard]] Value data() const override {
    Value table;
    table.set("problem", label_);
    table.set("cost", seen_.cost);
    table.set("quality", problem_.quality(seen_.cost));
    if (const auto error = problem_.relative_error(seen_.cost)) table.set("relative_error", *error);
    return table;
  }

  [[nodiscard]] std::string text() const override {
    return fmt::format("{}: {} coordinate{}\nat the start: quality {:.10g}, cost {:.10g}\n", label_,
                       problem_.space().size(), problem_.space().size() == 1 ? "" : "s", problem_.quality(seen_.cost),
                       seen_.cost);
  }

 private:
  const Problem& problem_;
  std::string label_;
  Evaluation seen_;
};

}  // namespace

std::vector<double> Exhibit::read(const std::filesystem::path& /*file*/) const {
  throw Refusal("this problem reads no values from a file");
}

std::optional<std::vector<double>> Exhibit::point(std::span<const double> /*values*/) const {
  throw Refusal("this problem doesn't say at which point a system is");
}

std::optional<std::vector<double>> PlainExhibit::point(std::span<const double> values) const {
  const Space& space = problem_.space();
  if (values.size() != space.size()) throw std::logic_error("a point has as many values as its space has coordinates");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(space.lower()[i] <= values[i] && values[i] <= space.upper()[i])) return std::nullopt;
  return std::vector(values.begin(), values.end());
}

std::unique_ptr<ShownSystem> PlainExhibit::show(const std::string& label, std::span<const double> values) const {
  return std::make_unique<PlainSystem>(problem_, label, values);
}

std::vector<ExportFormat> PlainExhibit::formats() const { return {{"coordinates", ".json", "JSON"}}; }

std::string PlainExhibit::write(const ExportFormat& /*format*/, std::span<const double> values) const {
  Value table;
  for (std::size_t i = 0; i < values.size(); ++i) table.set(problem_.space().name(i), values[i]);
  return to_json(table);
}

std::shared_ptr<const Exhibit> exhibit_of(const Problem& problem) {
  if (const Exhibit* own = problem.exhibit()) return {std::shared_ptr<const Exhibit>(), own};
  return std::make_shared<const PlainExhibit>(problem);
}

}  // namespace nodal
