// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The forms of pricing that there are, and what the choice between them goes by. A form is a constant in its own file,
/// and a row of the list in forms.cpp.
///
/// Costs are in block units: one 2×2 block of the factor, read once by all lanes (one to two nanoseconds on today's
/// processors). They are estimated from timings of the kernels; only their ratios matter.

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>

#include "displacements/lane_model.h"
#include "moves/pricing_form.h"
#include "tables/table.h"

namespace nodal::elastic {

/// The sizes that costs depend on, whatever the dimension in blocks of 2×2 numbers and vectors of two.
struct PricingSizes {
  double nodes, blocks, path, springs, groups, numbers;  ///< numbers: doubles of a pair in all lanes
  double members, coordinates, lane_factoring, scalar_factoring, listed;

  /// A system of more than four groups has registers of twice the width to go through.
  [[nodiscard]] double passes_per_block() const { return std::max(1.0, numbers / 8.0); }
  /// A full evaluation by CHOLMOD.
  [[nodiscard]] double value() const { return scalar_factoring + groups * (kScalarCall + kScalarSolve * blocks); }

  static constexpr double kScalarSolve = 3.0;   ///< one block of one group in a CHOLMOD triangular solve
  static constexpr double kScalarCall = 400.0;  ///< a CHOLMOD call for one group
};

inline constexpr double kListedPrice = 15.0;  ///< a proposal from the price list, call included
inline constexpr double kListedSpring = 2.5;  ///< one row of the price list brought up to date
inline constexpr double kLaneCall = 60.0;     ///< entering a solve by lanes: clearing vectors, first cache lines

/// Costs of one form. `excluded` says why it can't be used here, or is empty.
struct FormCost {
  double price = 0.0, accept = 0.0;
  double begin = 0.0;  ///< of taking over at a point
  double bytes = 0.0;
  std::string excluded = {};
};

struct PricingFormDescription {
  std::string_view name;
  std::string_view summary;  ///< as the option's help has it, after the name
  /// It keeps a price list: of parameters that are one to one with springs, and of so many loads per support group.
  bool listed = false;
  FormCost (*cost)(const PricingSizes& sizes);
  std::unique_ptr<PricingForm> (*make)(const ElasticModel& model, const LaneModel& lanes);
};

// The one that remains where no other will do.
extern const PricingFormDescription kFullForm;  // full_form.cpp

/// All of them, as people are told of them; of two that cost the same the first is taken.
[[nodiscard]] Table<PricingFormDescription> pricing_forms();

}  // namespace nodal::elastic
