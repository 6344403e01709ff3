// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which instruction sets the lane kernels were compiled for, and which of them runs here.

#include <cstddef>
#include <string>
#include <vector>

#include "lane_kernels.h"

namespace nodal::elastic {

/// An instruction set that kernels were compiled for: "sse2", "avx2", "avx512" on x86-64, "generic" elsewhere.
struct LaneInstructions {
  std::string name;
  bool usable = false;  ///< by the processor that this runs on
};
/// From the simplest to the widest.
[[nodiscard]] std::vector<LaneInstructions> lane_instructions();

/// Kernels for `lanes` groups, 1, 2, 4 or 8, in two or three dimensions. "auto" takes the widest usable instruction
/// set. std::invalid_argument for another number or dimension, or an instruction set that is unknown or can't be used
/// here.
[[nodiscard]] const LaneKernels& lane_kernels(const std::string& instructions, std::size_t dimension,
                                              std::size_t lanes);
/// The name that "auto" stands for here.
[[nodiscard]] std::string best_lane_instructions();

}  // namespace nodal::elastic
