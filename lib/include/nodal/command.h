// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a kind of problem adds to the program beside itself: commands of its own, lists for `nodal list`, columns for
/// tables.

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <nodal/options.h>

namespace nodal {

class Registry;

/// What a command works with. What it prints goes to `out`, and is shown or caught from there.
struct CommandContext {
  const Registry& registry;
  std::ostream& out;
  std::filesystem::path scenes;  ///< the folder of the studies that come with the program
};

/// A command: `nodal <name> [<positional>] [--<option> …]`. Options of a boolean type are flags; of an option that
/// takes a file `unit` is "FILE".
struct Command {
  std::string name = {};
  std::string summary = {};     ///< one line, for --help
  std::string positional = {};  ///< the option that is given without its name; empty for none
  OptionSchema options = {};
  /// Returns the exit code: 0, or 1 when what was asked for did not come out well. InputError for bad input.
  std::function<int(const Options&, const CommandContext&)> run = {};
};

/// A list of the things that a kind of problem has, for `nodal list <name>`: a line each.
struct Listing {
  std::string name = {};
  std::vector<std::string> lines = {};
};

/// A figure that a problem finds at a point beside its quality: a column of optimizers.csv and, where it is `tabled`,
/// of table and page.
struct FindingDescription {
  std::string name = {};   ///< as Finding has it; in optimizers.csv <name>_median and quartiles
  std::string title = {};  ///< as people read it: "k_max/k_min"
  std::string unit = {};   ///< "" for dimensionless
  std::string help = {};   ///< one sentence for a tooltip
  bool tabled = false;
  bool floor =
      false;  ///< of relative errors: one below it is no result, since what it is told against isn't known better
};

}  // namespace nodal
