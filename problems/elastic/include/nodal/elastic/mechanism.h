// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A net that is refused because some of its nodes can move without any spring's resistance, whatever the stiffnesses.
///
/// Shapes   motion: [dimension · nodes], the largest displacement 1; to first order no spring changes its length along
///          it.

#include <string>
#include <utility>
#include <vector>

#include <nodal/elastic/net.h>
#include <nodal/exhibit.h>

namespace nodal::elastic {

class MechanismError final : public DrawnInputError {
 public:
  MechanismError(const Source& source, const std::string& message, Net of_net, std::vector<double> of_motion)
      : DrawnInputError(source, message), net(std::move(of_net)), motion(std::move(of_motion)) {}

  /// The net, and the nodes that move.
  [[nodiscard]] std::string picture(const std::string& name) const override;

  Net net;
  std::vector<double> motion;
};

}  // namespace nodal::elastic
