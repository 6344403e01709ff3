// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/registry.h>

namespace nodal {

namespace {

/// Uniform points of the box until the meter is spent: the floor under every comparison.
class RandomSearch final : public Optimizer {
 public:
  Outcome minimize(Meter& meter, std::span<const double>, RandomStream& random) override {
    const Space& space = meter.space();
    std::vector<double> x(space.size());
    while (!meter.spent()) {
      for (std::size_t i = 0; i < x.size(); ++i) x[i] = random.uniform(space.lower()[i], space.upper()[i]);
      (void)meter.value(x);
    }
    return {};
  }
};

}  // namespace

void register_random_search(Registry& registry) {
  registry.add(OptimizerDescription{.name = "random-search",
                                    .summary = "independent uniform points of the box: what any method must beat",
                                    .reference =
                                        "S. Brooks, A discussion of random methods for seeking maxima, Operations "
                                        "Research 6(2), 1958",
                                    .needs = {},
                                    .deterministic = false,
                                    .uses_start = false,
                                    .local = false,
                                    .options = {},
                                    .make = [](const Options&) { return std::make_unique<RandomSearch>(); },
                                    .suits =
                                        [](const Problem&) {
                                          return Suitability{0, "it needs nothing but values"};
                                        }});
}

}  // namespace nodal
