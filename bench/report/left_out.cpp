// SPDX-License-Identifier: GPL-3.0-or-later
#include "left_out.h"

#include <algorithm>
#include <utility>

namespace nodal::report {

std::vector<std::string> left_out_lines(std::span<const LeftOut> left_out) {
  std::vector<std::pair<std::string, std::string>> labels_by_reason;
  for (const LeftOut& entry : left_out) {
    const auto same = std::ranges::find(labels_by_reason, entry.reason, &std::pair<std::string, std::string>::first);
    if (same == labels_by_reason.end())
      labels_by_reason.emplace_back(entry.reason, entry.label);
    else
      same->second += ", " + entry.label;
  }
  std::vector<std::string> lines;
  for (const auto& [reason, labels] : labels_by_reason) lines.push_back(labels + ": " + reason);
  return lines;
}

}  // namespace nodal::report
