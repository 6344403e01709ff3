// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Counts calls of operator new in a program that links count_allocations.cpp.

namespace nodal {

[[nodiscard]] long allocation_count() noexcept;

}  // namespace nodal
