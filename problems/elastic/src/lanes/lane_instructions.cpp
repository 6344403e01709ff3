// SPDX-License-Identifier: GPL-3.0-or-later
#include "lane_instructions.h"

#include <algorithm>
#include <bit>
#include <span>
#include <stdexcept>

namespace nodal::elastic {

namespace lanes_baseline {
extern const LaneKernels kernels[4];
}
namespace lanes_baseline_space {
extern const LaneKernels kernels[4];
}
#if defined(__x86_64__)
namespace lanes_avx2 {
extern const LaneKernels kernels[4];
}
namespace lanes_avx2_space {
extern const LaneKernels kernels[4];
}
namespace lanes_avx512 {
extern const LaneKernels kernels[4];
}
namespace lanes_avx512_space {
extern const LaneKernels kernels[4];
}
#endif

namespace {

struct Compiled {
  const char* name;
  bool usable;
  const LaneKernels* kernels[2];  // in the plane and in space; [4]: for 1, 2, 4 and 8 lanes
};

std::span<const Compiled> compiled() {
#if defined(__x86_64__)
  static const Compiled all[] = {
      {"sse2", true, {lanes_baseline::kernels, lanes_baseline_space::kernels}},
      {"avx2",
       __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"),
       {lanes_avx2::kernels, lanes_avx2_space::kernels}},
      {"avx512",
       __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"),
       {lanes_avx512::kernels, lanes_avx512_space::kernels}},
  };
#else
  static const Compiled all[] = {{"generic", true, {lanes_baseline::kernels, lanes_baseline_space::kernels}}};
#endif
  return all;
}

const Compiled& best() {
  const Compiled* widest = nullptr;
  for (const Compiled& c : compiled())
    if (c.usable) widest = &c;
  return *widest;
}

const Compiled& find(const std::string& name) {
  if (name == "auto") return best();
  for (const Compiled& c : compiled()) {
    if (name != c.name) continue;
    if (!c.usable) throw std::invalid_argument("this processor has no " + name);
    return c;
  }
  throw std::invalid_argument("this build has no kernels for '" + name + "'");
}

}  // namespace

std::vector<LaneInstructions> lane_instructions() {
  std::vector<LaneInstructions> result;
  for (const Compiled& c : compiled()) result.push_back({c.name, c.usable});
  return result;
}

std::string best_lane_instructions() { return best().name; }

const LaneKernels& lane_kernels(const std::string& instructions, std::size_t dimension, std::size_t lanes) {
  if (dimension != 2 && dimension != 3) throw std::invalid_argument("lanes have two or three dimensions");
  if (!std::has_single_bit(lanes) || lanes > 8) throw std::invalid_argument("lanes come in 1, 2, 4 or 8");
  return find(instructions).kernels[dimension - 2][std::countr_zero(lanes)];
}

}  // namespace nodal::elastic
