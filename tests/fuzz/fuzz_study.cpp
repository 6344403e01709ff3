// SPDX-License-Identifier: GPL-3.0-or-later
// Studies: TOML, tables, options of every problem. Elastic systems are not built: a few words can ask for a large one.
#include <memory>

#include <nodal/registry.h>
#include <nodal/study.h>

#include "fuzz_target.h"

namespace nodal {

void register_analytic(Registry& registry);
void register_elastic(Registry& registry);

namespace {

class Nothing final : public Problem {
 public:
  [[nodiscard]] const Space& space() const override { return space_; }
  [[nodiscard]] Abilities abilities() const override { return {.gradient = true}; }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override { return nullptr; }

 private:
  Space space_{{{"x", 0.0, 1.0, 0.5}}};
};

Registry make_registry() {
  Registry all, registry;
  register_analytic(all);
  register_elastic(all);
  for (ProblemDescription problem : all.problems()) {
    problem.make = [](const Options&, const ProblemContext&) { return std::make_shared<Nothing>(); };
    registry.add(std::move(problem));
  }
  registry.add(OptimizerDescription{.name = "walk",
                                    .needs = {.gradient = true},
                                    .local = true,
                                    .options = {{.name = "step", .default_value = 1.0, .minimum = 0.0},
                                                {.name = "kind", .type = OptionType::text, .choices = {"a", "b"}}},
                                    .make = [](const Options&) { return nullptr; }});
  return registry;
}

}  // namespace
}  // namespace nodal

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const nodal::Registry registry = nodal::make_registry();
  return nodal::fuzz::read(data, size,
                           [](std::string_view text) { (void)nodal::parse_study(text, "s.toml", registry); });
}
