// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include <fmt/format.h>

#include <nodal/merge.h>

#include "commands.h"
#include "console.h"

namespace nodal {

int merge_command(const MergeArguments& arguments, const Registry&) {
  std::vector<Store> stores;
  for (const std::string& directory : arguments.directories) stores.push_back(Store::open_existing(directory));
  const MergedStores merged = merge_stores(stores);
  write_merged(stores, merged, arguments.out);
  for (const std::string& warning : merged.warnings) say("warning", warning);
  std::cout << fmt::format("{} trials of {} stores are in '{}'\n", merged.records.size() + merged.not_asked_for.size(),
                           stores.size(), arguments.out);
  return 0;
}

}  // namespace nodal
