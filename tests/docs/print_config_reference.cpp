// SPDX-License-Identifier: GPL-3.0-or-later
// Prints docs/config_reference.md.
#include <iostream>

#include <nodal/components.h>

#include "config_reference.h"

int main() {
  nodal::Registry registry;
  nodal::register_components(registry);
  if (!nodal::docs::is_complete(registry)) {
    std::cerr << "this build lacks a library, so its page would lack sections; configure with NODAL_NLOPT=ON and "
                 "NODAL_CERES=ON\n";
    return 1;
  }
  std::cout << nodal::docs::config_reference(registry);
}
