// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include <nodal/store.h>

#include "commands.h"
#include "console.h"
#include "output_file.h"
#include "write_report.h"

namespace nodal {

int report_command(const ReportArguments& arguments, const Registry& registry) {
  if (!arguments.latex.empty()) refuse_no_tables("--latex", arguments.latex);
  std::vector<Store> stores;
  for (const std::string& directory : arguments.directories) stores.push_back(Store::open_existing(directory));
  if (arguments.out.empty() && stores.size() > 1)
    throw InputError("several stores make one report of their own; say where it goes with --out DIR");
  if (arguments.out.empty()) {
    write_report(stores, registry, stores.front(), {.latex = arguments.latex});
  } else {
    Store target{arguments.out};
    write_report(stores, registry, target, {.latex = arguments.latex});
  }
  return 0;
}

}  // namespace nodal
