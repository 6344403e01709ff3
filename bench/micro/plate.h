// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the benchmarks share: plates of the default study, points to evaluate, and a fair way to time two things.

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>
#include <nodal/elastic/elastic_problem.h>

namespace nodal::micro {

/// Everything that this build can compare.
[[nodiscard]] const Registry& components();

/// The default plate with `nodes` = n² nodes, every spring its own coordinate.
/// `options`: further lines of its problem table.
[[nodiscard]] std::shared_ptr<const elastic::ElasticProblem> make_plate(std::size_t nodes,
                                                                        const std::string& options = "");

/// Points around the start, each coordinate moved by up to ±20 %: no two calls in a row see the same one.
[[nodiscard]] std::vector<std::vector<double>> make_points(const Space& space, std::size_t count);

/// This thread's processor time: what others do on the machine at the moment counts for neither side.
[[nodiscard]] double processor_seconds();

/// Processor seconds per call of two things, as the medians over blocks that alternate, so that a slow moment of the
/// machine meets both. `first` and `second` run their thing once.
struct Pair {
  double first = 0.0, second = 0.0;
};
[[nodiscard]] Pair time_alternating(const std::function<void()>& first, const std::function<void()>& second,
                                    double block_seconds = 1e-3, std::size_t blocks = 401);

}  // namespace nodal::micro
