// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The net that a study asks for: points, joined by springs.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nodal/elastic/account.h>
#include <nodal/elastic/net.h>
#include <nodal/options.h>
#include <nodal/registry.h>

namespace nodal::elastic {

/// A net, and what a file of springs knows beyond it.
struct StudyNet {
  Net net;
  std::vector<double> stiffness;                     ///< [springs]; empty unless the file has them
  std::vector<std::string> groups;                   ///< [springs]; empty unless the file has them
  std::optional<std::array<double, 2>> bounds = {};  ///< N/m; those that the file says, if any
};

/// InputError with the source of the value at fault.
[[nodiscard]] StudyNet read_net(const Options& problem, const ProblemContext& context, const Body& body,
                                Account& account);

}  // namespace nodal::elastic
