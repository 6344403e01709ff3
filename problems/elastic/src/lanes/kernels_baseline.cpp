// SPDX-License-Identifier: GPL-3.0-or-later
#define NODAL_LANE_WIDTH 2
#define NODAL_LANE_DIMENSION 2
#define NODAL_LANE_NAMESPACE lanes_baseline
#include "lane_kernels.inl"
