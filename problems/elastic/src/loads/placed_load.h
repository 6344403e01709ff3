// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A load on a net's nodes, before it is known how the body answers it; and the same said about the body, for whoever
/// computes that answer.
///
/// A body's border is known here by the pieces that a net's nodes divide it into: piece k is the k-th of
/// for_each_border_piece.
///
/// Shapes   forces: [freedoms].
/// Units    Pa, N, N/m³, m.

#include <cstddef>
#include <string>
#include <vector>

#include <nodal/elastic/loads.h>

#include "loads/load_spec.h"
#include "loads/stress_field.h"

namespace nodal::elastic {

/// Pulls at each of the pieces with the traction σ·n + `traction`.
struct BorderPull {
  std::vector<std::size_t> pieces;  ///< ascending
  StressField stress = {};
  Vector traction{};
  bool local_thickness =
      false;  ///< times the thickness that the body has there, where regions have others; else its own
};

/// Holds each of the pieces along an axis, at a displacement.
struct BorderHold {
  std::vector<std::size_t> pieces;  ///< ascending
  std::size_t axis = 0;
  double value = 0.0;

  friend bool operator==(const BorderHold&, const BorderHold&) = default;
};

/// A load as the body sees it. Nodes that are held without a piece beside them are held as points.
struct BodyLoad {
  std::vector<BorderPull> pulls;
  std::vector<BorderHold> holds;
  std::vector<Support> points;   ///< of nodes that no held piece holds along that axis, ascending
  Vector body_force{};           ///< everywhere in the body, N/m³
  bool forces_on_nodes = false;  ///< some pull at points that are free to move, which no continuum bears
};

struct PlacedLoad {
  std::string name;
  std::vector<double> forces;
  SupportGroup group = {};
  std::vector<std::size_t> held_as_reference = {};  ///< freedoms among the supports', ascending, that are held where
                                                    ///< the reference has them; at 0 until then
  BodyLoad body = {};
  bool beside_set = false;  ///< as LoadCase has it
};

/// Of a net whose body has a border to pull at. Refusal as make_basic_loads.
[[nodiscard]] PlacedLoad place(const LoadSpec& spec, const Net& net);

/// The displacements of a homogeneous body under a load, with the net's nodes held as `place` does.
/// std::invalid_argument where why_no_closed_form has some reason.
[[nodiscard]] std::vector<double> closed_form(const LoadSpec& spec, const Net& net, const MaterialField& material);

/// Moves what is held as the reference has it to where this one does.
void hold_as_reference(PlacedLoad& load, const std::vector<double>& reference, const Freedoms& freedoms);

/// The load with its reference, of no group yet. Takes name and forces out of it.
[[nodiscard]] LoadCase load_case(PlacedLoad&& load, std::vector<double> reference,
                                 std::vector<double> uncertainty = {});

}  // namespace nodal::elastic
