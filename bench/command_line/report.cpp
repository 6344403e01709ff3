// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <optional>

#include <nodal/store.h>

#include "commands.h"
#include "write_report.h"

namespace nodal {

namespace {

struct ReportArguments {
  std::vector<std::string> directories;
  std::string out;
};

int report_command(const ReportArguments& arguments, const Registry& registry) {
  std::vector<Store> stores;
  for (const std::string& directory : arguments.directories) {
    stores.push_back(Store::open_existing(directory));
    for (const std::string& warning : stores.back().warnings()) std::cerr << "warning: " << warning << '\n';
  }
  if (arguments.out.empty() && stores.size() > 1)
    throw InputError("several stores make one report of their own; say where it goes with --out DIR");
  if (arguments.out.empty()) {
    write_report(stores, registry, stores.front());
  } else {
    Store target{arguments.out};
    write_report(stores, registry, target);
  }
  return 0;
}

}  // namespace

void add_report(CLI::App& app, Program& program) {
  CLI::App* command = app.add_subcommand("report", "Make table, summary.csv and report.html again from stored trials");
  const auto arguments = std::make_shared<ReportArguments>();
  command->add_option("stores", arguments->directories, "Directories that nodal compare wrote")
      ->required()
      ->type_name("DIR…");
  command->add_option("--out", arguments->out, "Where the files go (default: into the one store)")->type_name("DIR");
  command->callback([arguments, &program] { program.exit = report_command(*arguments, program.registry); });
}

}  // namespace nodal
