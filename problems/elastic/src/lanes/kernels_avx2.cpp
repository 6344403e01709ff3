// SPDX-License-Identifier: GPL-3.0-or-later
#define NODAL_LANE_WIDTH 4
#define NODAL_LANE_DIMENSION 2
#define NODAL_LANE_NAMESPACE lanes_avx2
#include "lane_kernels.inl"
