// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Finds nodes by what people call them.

#include <cstdint>
#include <unordered_map>

#include <nodal/elastic/net.h>
#include <nodal/error.h>

namespace nodal::elastic {

class NodeNames {
 public:
  explicit NodeNames(const Net& net);

  /// InputError at `source` when the net has no such node.
  [[nodiscard]] std::size_t find(std::int64_t id, const Source& source) const;

 private:
  std::unordered_map<std::int64_t, std::size_t> index_;
};

}  // namespace nodal::elastic
