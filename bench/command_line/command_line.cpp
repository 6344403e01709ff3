// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/command_line.h>

#include <exception>
#include <iostream>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/provenance.h>

#include "commands.h"
#include "usage_error.h"

namespace nodal {

namespace {

std::string version_text() {
  std::string text = fmt::format("nodal {} (revision {})\n", version(), revision());
  const Value here = provenance();
  text += fmt::format("compiler: {}, {}\n", here.at("compiler").text(), here.at("build_type").text());
  for (const auto& [name, number] : library_versions()) text += fmt::format("{}: {}\n", name, number);
  return text;
}

void describe(CLI::App& app) {
  app.description("Compares optimizers on fitting spring/mass systems to elastic bodies.");
  app.footer(
      "Start with: nodal compare bench/scenes/plate.toml\n"
      "Exit codes: 0 done, 1 a trial failed, 2 bad input or usage, 130 interrupted.");
  app.require_subcommand(1);
  app.set_help_all_flag("--help-all", "Help of all commands");
  app.add_flag_callback(
      "--version", [] { throw CLI::CallForVersion(version_text(), 0); }, "Revision and library versions");
}

}  // namespace

int command_line(const Registry& registry, int argc, const char* const* argv) {
  CLI::App app("", "nodal");
  Program program{registry};
  describe(app);
  add_compare(app, program);
  add_evaluate(app, program);
  add_fit(app, program);
  add_report(app, program);
  add_explain(app, program);
  add_list(app, program);
  try {
    app.parse(argc, argv);
    std::cout.flush();
    return program.exit;
  } catch (const CLI::Success& done) {  // --help, --version
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    std::cerr << "nodal: " << describe_usage_error(app, error, argc, argv) << '\n';
  } catch (const InputError& error) {
    std::cerr << "nodal: " << error.what() << '\n';
  } catch (const StoreError& error) {
    std::cerr << "nodal: " << error.what() << '\n';
  } catch (const std::exception& error) {
    std::cerr << "nodal: " << error.what() << '\n';
  }
  return kExitBadInput;
}

}  // namespace nodal
