// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the benchmarks share: plates of the default study, blocks and points to evaluate.

#include <cstddef>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>
#include <nodal/alternating.h>
#include <nodal/elastic/elastic_problem.h>

namespace nodal::micro {

/// Everything that this build can compare.
[[nodiscard]] const Registry& components();

/// The default plate with `nodes` = n² nodes, every spring its own coordinate.
/// `options`: further lines of its problem table.
[[nodiscard]] std::shared_ptr<const elastic::ElasticProblem> make_plate(std::size_t nodes,
                                                                        const std::string& options = "");

/// A cube of `nodes` = n³ nodes, crossed, in unit cells, every spring its own coordinate.
[[nodiscard]] std::shared_ptr<const elastic::ElasticProblem> make_block(std::size_t nodes);

/// Points around the start, each coordinate moved by up to ±20 %: no two calls in a row see the same one.
[[nodiscard]] std::vector<std::vector<double>> make_points(const Space& space, std::size_t count);

using Pair = PairOfSeconds;

}  // namespace nodal::micro
