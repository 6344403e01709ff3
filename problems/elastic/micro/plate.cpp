// SPDX-License-Identifier: GPL-3.0-or-later
#include "plate.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <nodal/components.h>
#include <nodal/random.h>
#include <nodal/study.h>

namespace nodal::micro {

const Registry& components() {
  static const Registry registry = [] {
    Registry r;
    register_components(r);
    return r;
  }();
  return registry;
}

std::shared_ptr<const elastic::ElasticProblem> make_plate(std::size_t nodes, const std::string& options) {
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(nodes))));
  if (side * side != nodes) throw std::invalid_argument("make_plate: the number of nodes must be a square");
  const std::string text = fmt::format(
                               "[study]\nname = \"plate\"\n[problem]\nkind = \"elastic\"\n"
                               "body = {{ shape = \"rectangle\", size = [4.0, 4.0], thickness = 1.0 }}\n"
                               "points = {{ layout = \"grid\", counts = [{0}, {0}] }}\n",
                               side) +
                           options;
  return std::dynamic_pointer_cast<const elastic::ElasticProblem>(
      parse_study(text, "plate.toml", components()).problems.at(0).problem);
}

std::shared_ptr<const elastic::ElasticProblem> make_block(std::size_t nodes) {
  const auto side = static_cast<std::size_t>(std::lround(std::cbrt(static_cast<double>(nodes))));
  if (side * side * side != nodes) throw std::invalid_argument("make_block: the number of nodes must be a cube");
  const std::string text = fmt::format(
      "[study]\nname = \"block\"\n[problem]\nkind = \"elastic\"\nbody = {{ size = [{0}, {0}, {0}] }}\n"
      "points = {{ counts = [{1}, {1}, {1}] }}\nsprings = {{ initial = \"paper\" }}\n",
      side - 1, side);
  return std::dynamic_pointer_cast<const elastic::ElasticProblem>(
      parse_study(text, "block.toml", components()).problems.at(0).problem);
}

std::vector<std::vector<double>> make_points(const Space& space, std::size_t count) {
  RandomStream random(1);
  std::vector<std::vector<double>> points;
  for (std::size_t p = 0; p < count; ++p) {
    std::vector<double>& x = points.emplace_back(space.start().begin(), space.start().end());
    for (double& coordinate : x) coordinate += random.uniform(-0.2, 0.2);
    space.clamp(x);
  }
  return points;
}

}  // namespace nodal::micro
