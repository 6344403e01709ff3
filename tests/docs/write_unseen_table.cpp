// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the table of a finished comparison into a page: unseen_table docs/unseen_loads.md results/unseen
#include <cstdio>
#include <exception>
#include <vector>

#include <nodal/file.h>
#include <nodal/store.h>

#include "../support/components.h"
#include "unseen_table.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: unseen_table PAGE STORE\n", stderr);
    return 2;
  }
  try {
    std::vector<nodal::Store> stores;
    stores.push_back(nodal::Store::open_existing(argv[2]));
    const nodal::report::ReportData data = nodal::report::collect(stores, nodal::components());
    nodal::replace_file(
        argv[1], nodal::docs::with_unseen_table(nodal::read_file(argv[1], "page"), nodal::docs::unseen_table(data)));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "unseen_table: %s\n", error.what());
    return 2;
  }
}
