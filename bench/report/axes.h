// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <nodal/analysis.h>

namespace nodal::report {

/// What costs are told in of every problem; factorizations are only some problems'.
inline constexpr std::array<Axis, 3> kAxes = {Axis::seconds, Axis::evaluations, Axis::work};

}  // namespace nodal::report
