// SPDX-License-Identifier: GPL-3.0-or-later
// The lane kernels, compiled once per instruction set and dimension. The file that includes this defines
//   NODAL_LANE_WIDTH      doubles per vector register: 2, 4 or 8
//   NODAL_LANE_DIMENSION  2 or 3
//   NODAL_LANE_NAMESPACE  a namespace of its own
// Everything is in an anonymous namespace and nothing of the standard library is called: an inline function compiled
// here for a new processor must never be the copy that the linker keeps for the rest of the program.

#include "lane_derivatives.inl"
#include "lane_factorization.inl"
#include "lane_price_list.inl"
#include "lane_update.inl"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

template <int G, int D>
constexpr LaneKernels kKernels = {
    .factorize = factorize<G, D>,
    .solve = solve<G, D>,
    .solve_spring = solve_spring<G, D>,
    .solve_loads = solve_loads<G, D>,
    .correct = correct<G, D>,
    .weighted_error = weighted_error<G, D>,
    .adjoint = adjoint<G, D>,
    .product = product<G, D>,
    .squared_error = squared_error<G, D>,
    .displace = displace<G, D>,
    .displace_one = displace_one<G, D>,
    .change_factor = change_factor<G, D>,
    .price = price<G>,
    .fill_row = fill_row<G, D>,
    .change_and_solve = change_and_solve<G, D>,
    .update_table = update_table<G, D>,
};

}  // namespace

/// For 1, 2, 4 and 8 groups.
extern const LaneKernels kernels[4];
const LaneKernels kernels[4] = {
    kKernels<1, NODAL_LANE_DIMENSION>,
    kKernels<2, NODAL_LANE_DIMENSION>,
    kKernels<4, NODAL_LANE_DIMENSION>,
    kKernels<8, NODAL_LANE_DIMENSION>,
};

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
