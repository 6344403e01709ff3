// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The lane factor of up to eight support groups with its workspaces: the state that the kernels work on.
///
/// Cost     memory: 8·D² bytes per lane and block of the factor (made at the first factorize), and a few vectors.
/// Threads  one per thread.

#include <cstdint>
#include <span>

#include "lanes/lane_instructions.h"
#include "lanes/lane_structure.h"

namespace nodal::elastic {

class FullEvaluation;

/// Whether a plain solve with a lane factor of so many unknowns is as good as a race asks for (1e-10).
[[nodiscard]] bool trusted(const LaneFactored& factored, std::size_t unknowns) noexcept;

/// How the loads were solved for. Not `fine`: nothing is to be believed, and CHOLMOD has to be asked.
struct LaneSolved {
  bool fine = false;
  bool corrected = false;
};

class LaneSystem {
 public:
  /// The structure must outlive it.
  LaneSystem(const LaneStructure& structure, const LaneKernels& kernels);

  LaneFactored factorize(std::span<const double> stiffness);
  /// Factors K(stiffness) and solves for every slot, into [slots] vectors; where a plain solve is not to be trusted,
  /// with one correction, which must be small.
  LaneSolved solve(std::span<const double> stiffness, double* u);
  /// True when the factor's own displacements give the G of a full evaluation at the same stiffnesses, to 2.5e-10 of it
  /// and of the reference.
  [[nodiscard]] bool agrees_with(const FullEvaluation& solved, std::span<const double> stiffness,
                                 double reference_norm) const;
  /// Displacements of a full evaluation, into [slots] vectors.
  void take_displacements(const FullEvaluation& solved, double* u) const;

  [[nodiscard]] const LaneStructure& structure() const noexcept { return structure_; }
  [[nodiscard]] const LaneKernels& kernels() const noexcept { return kernels_; }
  [[nodiscard]] const LaneView& view() const noexcept { return view_; }
  [[nodiscard]] std::size_t table_stride() const noexcept {
    return elastic::table_stride(view_.slots, static_cast<std::uint32_t>(structure_.lanes()));
  }

 private:
  const LaneStructure& structure_;
  const LaneKernels& kernels_;
  AlignedArray blocks_, work_, z_, y_;
  LaneView view_;
};

}  // namespace nodal::elastic
