// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A registry of small problems and of optimizers that behave well and badly, and studies made with it.

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>

#include <nodal/registry.h>
#include <nodal/study.h>

#include "toy.h"

namespace nodal::toy {

/// Values only, and no known optimum.
class BareProblem final : public Problem {
 public:
  [[nodiscard]] const Space& space() const override { return space_; }
  [[nodiscard]] Abilities abilities() const override { return {}; }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override {
    return std::make_unique<ToyEvaluator>(bowl);
  }

 private:
  Space space_{{{"x", -2.0, 3.0, -1.5}}};
};

/// Finite costs, but a relative error that no record can hold.
class UnspeakableProblem final : public Problem {
 public:
  [[nodiscard]] const Space& space() const override { return space_; }
  [[nodiscard]] Abilities abilities() const override { return {}; }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override {
    return std::make_unique<ToyEvaluator>(bowl);
  }
  [[nodiscard]] std::optional<double> relative_error(double cost) const override { return std::sqrt(-1.0 - cost); }

 private:
  Space space_{{{"x", -2.0, 3.0, -1.5}}};
};

/// What nobody can evaluate, and throws what nobody expects.
class UnmadeProblem final : public Problem {
 public:
  [[nodiscard]] const Space& space() const override { return space_; }
  [[nodiscard]] Abilities abilities() const override { return {}; }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override { throw 42; }

 private:
  Space space_{{{"x", -2.0, 3.0, -1.5}}};
};

/// Halves the distance to the optimum of the bowl again and again, `factor` being the part of it that is left.
class Halving final : public Optimizer {
 public:
  explicit Halving(double factor) : factor_(factor) {}
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream&) override {
    std::vector<double> x(start.begin(), start.end());
    for (int i = 0; i < 40 && !meter.spent(); ++i) {
      for (std::size_t j = 0; j < x.size(); ++j) x[j] += (1.0 - factor_) * (0.25 * static_cast<double>(j + 1) - x[j]);
      (void)meter.value(x);
    }
    Outcome outcome;
    outcome.reason = "40 halvings";
    return outcome;
  }

 private:
  double factor_;
};

/// Points anywhere in the box.
class Wanderer final : public Optimizer {
 public:
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream& random) override {
    std::vector<double> x(start.begin(), start.end());
    while (!meter.spent()) {
      for (std::size_t j = 0; j < x.size(); ++j)
        x[j] = random.uniform(meter.space().lower()[j], meter.space().upper()[j]);
      (void)meter.value(x);
    }
    return {};
  }
};

/// Does one thing instead of searching.
class Misbehaving final : public Optimizer {
 public:
  explicit Misbehaving(void (*what)()) : what_(what) {}
  Outcome minimize(Meter&, std::span<const double>, RandomStream&) override {
    what_();
    return {};
  }

 private:
  void (*what_)();
};

/// Says a lot about its options.
class Talkative final : public Optimizer {
 public:
  Outcome minimize(Meter&, std::span<const double>, RandomStream&) override {
    Outcome outcome;
    outcome.effective_options.set("speech", std::string(300000, 'x'));
    return outcome;
  }
};

[[noreturn]] inline void hang() {
  for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
}

inline void add_misbehaving(Registry& registry, const char* name, void (*what)()) {
  registry.add(OptimizerDescription{.name = name,
                                    .make = [what](const Options&) { return std::make_unique<Misbehaving>(what); }});
}

inline void add_problems(Registry& registry) {
  registry.add(ProblemDescription{
      .kind = "bowl",
      .options = {{.name = "size", .type = OptionType::integer, .default_value = 3, .minimum = 1, .maximum = 100},
                  {.name = "even", .type = OptionType::boolean, .default_value = false}},
      .make = [](const Options& options, const ProblemContext& context) -> std::shared_ptr<const Problem> {
        if (options.boolean("even") && options.integer("size") % 2 != 0)
          throw InputError(context.source, "an even bowl needs an even size");
        return std::make_shared<ToyProblem>(static_cast<std::size_t>(options.integer("size")));
      }});
  registry.add(ProblemDescription{
      .kind = "bare", .make = [](const Options&, const ProblemContext&) { return std::make_shared<BareProblem>(); }});
  registry.add(ProblemDescription{.kind = "broken", .make = [](const Options&, const ProblemContext&) {
                                    return std::make_shared<ToyProblem>(
                                        3, [](std::span<const double>) -> double { throw 7; });
                                  }});
  registry.add(ProblemDescription{.kind = "unspeakable", .make = [](const Options&, const ProblemContext&) {
                                    return std::make_shared<UnspeakableProblem>();
                                  }});
  registry.add(ProblemDescription{.kind = "unmade", .make = [](const Options&, const ProblemContext&) {
                                    return std::make_shared<UnmadeProblem>();
                                  }});
}

inline Registry registry() {
  Registry registry;
  add_problems(registry);
  registry.add(OptimizerDescription{
      .name = "halving",
      .deterministic = true,
      .local = true,
      .options = {{.name = "factor",
                   .default_value = 0.5,
                   .minimum = 0.0,
                   .maximum = 1.0,
                   .minimum_excluded = true,
                   .maximum_excluded = true}},
      .make = [](const Options& options) { return std::make_unique<Halving>(options.number("factor")); }});
  registry.add(OptimizerDescription{
      .name = "wanderer", .uses_start = false, .make = [](const Options&) { return std::make_unique<Wanderer>(); }});
  registry.add(OptimizerDescription{.name = "newton",
                                    .needs = {.gradient = true, .residuals = true},
                                    .deterministic = true,
                                    .local = true,
                                    .make = [](const Options&) { return std::make_unique<Halving>(0.1); }});
  registry.add(OptimizerDescription{
      .name = "walker", .needs = {.moves = true}, .make = [](const Options&) { return std::make_unique<Wanderer>(); }});
  add_misbehaving(registry, "aborting", [] { std::abort(); });
  add_misbehaving(registry, "hanging", hang);
  add_misbehaving(registry, "leaving", [] { std::_Exit(3); });
  add_misbehaving(registry, "throwing", [] { throw std::runtime_error("lost its way"); });
  add_misbehaving(registry, "throwing-a-number", [] { throw 42; });
  registry.add(
      OptimizerDescription{.name = "unmade", .make = [](const Options&) -> std::unique_ptr<Optimizer> { throw 42; }});
  add_misbehaving(registry, "latin", [] { throw std::runtime_error("caf\xE9 ferm\xE9"); });
  registry.add(
      OptimizerDescription{.name = "talkative", .make = [](const Options&) { return std::make_unique<Talkative>(); }});
  add_misbehaving(registry, "piping", [] { std::raise(SIGPIPE); });
  registry.add(AbsentDescription{"nlopt-*", "needs NLopt: configure with -DNODAL_NLOPT=ON"});
  return registry;
}

/// Reads a study; lines are counted from the first after `R"(`, the file is called "s.toml".
inline Study study(std::string_view text, const StudyOverrides& overrides = {}) {
  return parse_study(text, "s.toml", registry(), overrides);
}

}  // namespace nodal::toy
