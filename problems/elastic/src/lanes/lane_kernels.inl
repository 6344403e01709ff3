// SPDX-License-Identifier: GPL-3.0-or-later
// The lane kernels, compiled once per instruction set. The file that includes this defines
//   NODAL_LANE_WIDTH      doubles per vector register: 2, 4 or 8
//   NODAL_LANE_NAMESPACE  a namespace of its own
// Everything is in an anonymous namespace and nothing of the standard library is called: an inline function compiled
// here for a new processor must never be the copy that the linker keeps for the rest of the program.

#include "lane_derivatives.inl"
#include "lane_factorization.inl"
#include "lane_price_list.inl"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

template <int G>
constexpr LaneKernels kKernels = {
    .factorize = factorize<G>,
    .solve = solve<G>,
    .solve_spring = solve_spring<G>,
    .solve_loads = solve_loads<G>,
    .correct = correct<G>,
    .weighted_error = weighted_error<G>,
    .adjoint = adjoint<G>,
    .product = product<G>,
    .squared_error = squared_error<G>,
    .displace = displace<G>,
    .displace_one = displace_one<G>,
    .change_factor = change_factor<G>,
    .price = price<G>,
    .fill_row = fill_row<G>,
    .change_and_solve = change_and_solve<G>,
    .update_table = update_table<G>,
};

}  // namespace

/// For 1, 2, 4 and 8 groups.
extern const LaneKernels kernels[4];
const LaneKernels kernels[4] = {kKernels<1>, kKernels<2>, kKernels<4>, kKernels<8>};

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
