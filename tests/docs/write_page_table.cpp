// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the table of a finished comparison into the page that has one of its study: page_table README.md results/plate
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <nodal/file.h>
#include <nodal/store.h>

#include "../support/components.h"
#include "figure_table.h"
#include "marked_table.h"
#include "readme_table.h"
#include "unseen_table.h"

namespace nodal::docs {

namespace {

// A page with its table replaced by that of a comparison.
std::string with_table_of(const std::string& page, const Store& store, const report::ReportData& data) {
  const std::string& study = data.study_name;
  if (study == "plate") return with_table(page, data);
  if (study == "unseen") return with_marked_table(page, kUnseenStudy, unseen_table(data));
  const bool errors = study == "schedule" || study == "gradients";
  return with_marked_table(page, paper_study(study),
                           study == "fig02" ? voronoi_table(store.manifest())
                           : errors         ? errors_table(data)
                                            : figure_table(data));
}

void rewrite(const char* page, const char* directory) {
  std::vector<Store> stores;
  stores.push_back(Store::open_existing(directory));
  replace_file(page, with_table_of(read_file(page, "page"), stores.front(), report::collect(stores, components())));
}

}  // namespace

}  // namespace nodal::docs

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: page_table PAGE STORE\n", stderr);
    return 2;
  }
  try {
    nodal::docs::rewrite(argv[1], argv[2]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "page_table: %s\n", error.what());
    return 2;
  }
}
