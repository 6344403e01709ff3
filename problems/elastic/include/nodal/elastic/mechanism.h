// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A net that is refused because some of its nodes can move without any spring's resistance, whatever the stiffnesses.
///
/// Shapes   motion: [2 · nodes], the largest displacement 1; to first order no spring changes its length along it.

#include <vector>

#include <nodal/elastic/net.h>
#include <nodal/error.h>

namespace nodal::elastic {

/// Bad input of a kind that can be drawn.
class MechanismError final : public InputError {
 public:
  MechanismError(const Source& source, const std::string& message, Net of_net, std::vector<double> of_motion)
      : InputError(source, message), net(std::move(of_net)), motion(std::move(of_motion)) {}

  Net net;
  std::vector<double> motion;
};

}  // namespace nodal::elastic
