// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include <nodal/trial.h>

#include "toy.h"

namespace {

class Middle final : public nodal::Optimizer {
 public:
  nodal::Outcome minimize(nodal::Meter& meter, std::span<const double>, nodal::RandomStream&) override {
    (void)meter.value(std::vector<double>{0.25, 0.5});
    nodal::Outcome outcome;
    outcome.reason = "looked";
    return outcome;
  }
};

constexpr const char* kStudy = R"(
[budget]
evaluations = 10
[problem]
kind = "toy"
[[optimizer]]
use = "middle"
)";

}  // namespace

int main() {
  nodal::Registry registry;
  registry.add(toy());
  nodal::OptimizerDescription middle;
  middle.name = "middle";
  middle.deterministic = true;
  middle.make = [](const nodal::Options&) { return std::make_unique<Middle>(); };
  registry.add(middle);
  const nodal::Study study = nodal::parse_study(kStudy, "study.toml", registry);
  std::cout << nodal::to_json_line(nodal::run_trial(study, {}, registry)) << '\n';
}
