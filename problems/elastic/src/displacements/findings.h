// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The findings of every point: what its springs are like, whatever pulls at them.
///
/// Cost     in proportion to the springs.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <nodal/elastic/net.h>
#include <nodal/evaluator.h>

namespace nodal::elastic {

struct ElasticModel;

inline constexpr std::string_view kSpread = "spread";
inline constexpr std::string_view kStableStep = "stable_step";
inline constexpr std::string_view kReferenceError = "reference_error";

/// k_max/k_min, the stiffest spring over the softest.
[[nodiscard]] double spread_of(std::span<const double> stiffness);

/// [s] 2/ω with ω² = max_i (2/m_i) Σ_e k_e over the springs at node i: explicit integration in time is stable below it,
/// since no frequency of the net is higher, held or free. Nothing without masses, or where some node has none.
[[nodiscard]] std::optional<double> stable_step_of(const Net& net, std::span<const double> stiffness);

/// All of them that there are, the reference's error of the model's own loads among them.
[[nodiscard]] std::vector<Finding> findings_of(const ElasticModel& model, std::span<const double> stiffness);

}  // namespace nodal::elastic
