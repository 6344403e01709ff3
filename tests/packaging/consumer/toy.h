// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The least that a problem can be: values only.

#include <stdexcept>

#include <nodal/registry.h>

class ToyEvaluator final : public nodal::Evaluator {
 public:
  nodal::Evaluation value(std::span<const double> x) override {
    if (x.size() != 2) throw std::invalid_argument("a toy has two coordinates");
    return {nodal::Status::ok, (x[0] - 0.25) * (x[0] - 0.25) + (x[1] - 0.5) * (x[1] - 0.5)};
  }
};

class Toy final : public nodal::Problem {
 public:
  [[nodiscard]] const nodal::Space& space() const override { return space_; }
  [[nodiscard]] nodal::Abilities abilities() const override { return {}; }
  [[nodiscard]] std::unique_ptr<nodal::Evaluator> make_evaluator() const override {
    return std::make_unique<ToyEvaluator>();
  }

 private:
  nodal::Space space_{{{"a", -1.0, 1.0, 0.0}, {"b", -1.0, 1.0, 0.0}}};
};

inline nodal::ProblemDescription toy() {
  nodal::ProblemDescription description;
  description.kind = "toy";
  description.summary = "a bowl of the consumer's";
  description.make = [](const nodal::Options&, const nodal::ProblemContext&) { return std::make_shared<Toy>(); };
  return description;
}
