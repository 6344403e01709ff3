// SPDX-License-Identifier: GPL-3.0-or-later
#include "plate.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include <fmt/format.h>

#include <nodal/components.h>
#include <nodal/random.h>
#include <nodal/study.h>

namespace nodal::micro {

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

namespace {

double seconds_of(const std::function<void()>& run, std::size_t calls) {
  const double began = processor_seconds();
  for (std::size_t i = 0; i < calls; ++i) run();
  return processor_seconds() - began;
}

// How many calls fill a block; the doubling also warms up.
std::size_t calls_per_block(const std::function<void()>& run, double block_seconds) {
  std::size_t calls = 1;
  while (seconds_of(run, calls) < block_seconds) calls *= 2;
  return calls;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

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

Pair time_alternating(const std::function<void()>& first, const std::function<void()>& second, double block_seconds,
                      std::size_t blocks) {
  const std::size_t first_calls = calls_per_block(first, block_seconds),
                    second_calls = calls_per_block(second, block_seconds);
  std::vector<double> first_seconds, second_seconds;
  for (std::size_t b = 0; b < blocks; ++b) {
    first_seconds.push_back(seconds_of(first, first_calls) / static_cast<double>(first_calls));
    second_seconds.push_back(seconds_of(second, second_calls) / static_cast<double>(second_calls));
  }
  return {median(first_seconds), median(second_seconds)};
}

}  // namespace nodal::micro
