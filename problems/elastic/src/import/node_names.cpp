// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/node_names.h"

#include <fmt/format.h>

namespace nodal::elastic {

NodeNames::NodeNames(const Net& net) {
  for (std::size_t i = 0; i < net.nodes.size(); ++i) index_.emplace(net.id(i), i);
}

std::size_t NodeNames::find(std::int64_t id, const Source& source) const {
  const auto found = index_.find(id);
  if (found == index_.end())
    throw InputError(source, fmt::format("there is no node {}; the system has {} nodes", id, index_.size()));
  return found->second;
}

}  // namespace nodal::elastic
