// SPDX-License-Identifier: GPL-3.0-or-later
#include "core.h"

#include <algorithm>
#include <thread>

namespace nodal {

std::int64_t allowed_cores() {
  cpu_set_t mask;
  CPU_ZERO(&mask);
  if (::sched_getaffinity(0, sizeof mask, &mask) == 0) return std::max(1, CPU_COUNT(&mask));
  return std::max(1u, std::thread::hardware_concurrency());  // more than the mask has room for
}

std::optional<int> present_core() {
  const int core = ::sched_getcpu();
  return core >= 0 && core < CPU_SETSIZE ? std::optional(core) : std::nullopt;
}

OnCore::OnCore(std::optional<int> core) {
  if (!core || ::sched_getaffinity(0, sizeof before_, &before_) != 0) return;
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(*core, &only);
  if (::sched_setaffinity(0, sizeof only, &only) == 0) core_ = core;
}

OnCore::~OnCore() {
  if (core_) ::sched_setaffinity(0, sizeof before_, &before_);
}

}  // namespace nodal
