// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What can be set on a method of NLopt, under the library's own names.

#include <nodal/options.h>

#include <cstdint>
#include <optional>
#include <string>

#include "methods.h"

namespace nodal::nlopt_methods {

/// When a local search ends by itself. The race is ended by the meter; so these only catch a search that can't improve
/// any more: a few units of rounding for what it changes. 0 switches one off.
struct Tolerances {
  double xtol_rel = 1e-12;  ///< Σ|Δx| ≤ this · Σ|x|
  double xtol_abs = 0.0;    ///< |Δx_i| ≤ this for every i
  double ftol_rel = 1e-15;  ///< |Δcost| ≤ this · |cost|
};

struct Settings {
  Tolerances tolerances;
  std::optional<std::int64_t> population, vector_storage;
  std::optional<double> initial_step, first_cost;
  std::string local;  ///< short name of the method that polishes samples; empty for none
};

/// Looser for the local searches of a multi-level search: it has many to pay for, and it gives up for good when one of
/// them reports that rounding stopped it.
[[nodiscard]] Tolerances default_tolerances(LocalSearch kind);

[[nodiscard]] OptionSchema make_schema(const Method& method);
[[nodiscard]] Settings read_settings(const Options& options);

/// Steps that a method remembers unless told: all that a small problem can use, and few enough that a large one stays
/// cheap. The library's own default, 10 MB worth of them, costs more to clear than a whole search on a small plate.
[[nodiscard]] std::int64_t default_vector_storage(std::size_t coordinates);

/// Luksan's methods end at a gradient of 1e-8, whatever their tolerances: on the bench plate at ν = 1/3 that is G =
/// 5e-4 for a fit that can be exact. Seen from 1e5 downwards the cost has lost 13 digits by then.
inline constexpr double kFirstCost = 1e5;

}  // namespace nodal::nlopt_methods
