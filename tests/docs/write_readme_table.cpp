// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the table of a finished comparison into README.md: readme_table README.md results/plate
#include <cstdio>
#include <exception>
#include <vector>

#include <nodal/file.h>
#include <nodal/store.h>

#include "../support/components.h"
#include "readme_table.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: readme_table README STORE\n", stderr);
    return 2;
  }
  try {
    std::vector<nodal::Store> stores;
    stores.push_back(nodal::Store::open_existing(argv[2]));
    nodal::replace_file(argv[1], nodal::docs::with_table(nodal::read_file(argv[1], "page"),
                                                         nodal::report::collect(stores, nodal::components())));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "readme_table: %s\n", error.what());
    return 2;
  }
}
