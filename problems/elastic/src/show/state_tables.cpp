// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/state_tables.h"

#include <algorithm>

#include <fmt/format.h>

namespace nodal::elastic::show {

namespace {

constexpr std::size_t kMostLines = 100;

template <class Line>
std::string table(const std::string& head, std::size_t count, Line line) {
  std::string text = "\n" + head + "\n";
  for (std::size_t i = 0; i < std::min(count, kMostLines); ++i) text += line(i) + "\n";
  if (count > kMostLines) text += fmt::format("… and {} more: --json has all\n", count - kMostLines);
  return text;
}

}  // namespace

std::string state_tables(const Net& net, const LoadState& load) {
  std::string text = fmt::format("\nload '{}'\n", load.name);
  std::string head = fmt::format("{:>10}", "node");
  for (std::size_t axis = 0; axis < net.dimension; ++axis)
    head += fmt::format(" {:>16}", fmt::format("u{} [m]", kAxisNames[axis]));
  text += table(head, net.nodes.size(), [&](std::size_t i) {
    std::string line = fmt::format("{:>10}", net.id(i));
    for (std::size_t axis = 0; axis < net.dimension; ++axis)
      line += fmt::format(" {:>16.8g}", load.displacement[net.freedoms().at(i, axis)]);
    return line;
  });
  text += table(fmt::format("{:>10} {:>10} {:>16}", "spring", "", "force [N]"), net.springs.size(), [&](std::size_t e) {
    return fmt::format("{:>10} {:>10} {:>16.8g}", net.id(net.springs[e].first), net.id(net.springs[e].second),
                       load.spring_force[e]);
  });
  text += table(fmt::format("{:>10} {:>10} {:>16}", "support", "axis", "force [N]"), load.supports.size(),
                [&](std::size_t s) {
                  return fmt::format("{:>10} {:>10} {:>16.8g}", net.id(load.supports[s].node),
                                     kAxisNames[load.supports[s].axis], load.bearing[s]);
                });
  return text;
}

}  // namespace nodal::elastic::show
