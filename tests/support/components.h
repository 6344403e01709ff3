// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Everything that this build can compare, registered once per test program.

#include <nodal/components.h>

namespace nodal {

inline const Registry& components() {
  static const Registry all = [] {
    Registry registry;
    register_components(registry);
    return registry;
  }();
  return all;
}

}  // namespace nodal
