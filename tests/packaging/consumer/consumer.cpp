// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/command_line.h>
#include <nodal/components.h>

#include "toy.h"

int main(int argc, char** argv) {
  nodal::Registry registry;
  nodal::register_components(registry);
  registry.add(toy());
  return nodal::command_line(registry, argc, argv);
}
