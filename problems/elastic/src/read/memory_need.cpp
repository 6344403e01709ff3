// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/memory_need.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace nodal::elastic {

namespace fs = std::filesystem;

double memory_need(std::size_t nodes, std::size_t groups, std::size_t dimension) {
  if (dimension == 3) {
    constexpr double kOfBlock = 1600.0, kOfBlockGroup = 1900.0;
    return std::pow(static_cast<double>(nodes), 4.0 / 3.0) * (kOfBlock + kOfBlockGroup * static_cast<double>(groups));
  }
  constexpr double kOfNet = 200.0, kOfGroup = 250.0;
  const double n = static_cast<double>(nodes);
  return n * std::log2(n + 1.0) * (kOfNet + kOfGroup * static_cast<double>(groups));
}

bool memory_suffices(std::size_t nodes, std::size_t groups, double memory, std::size_t dimension) {
  constexpr double kShare = 0.75;
  return memory_need(nodes, groups, dimension) <= kShare * memory;
}

void require_memory(std::size_t nodes, std::optional<std::size_t> groups, double memory, const Source& source,
                    std::size_t dimension) {
  constexpr double kGigabyte = 1e9;
  if (memory_suffices(nodes, groups.value_or(1), memory, dimension)) return;
  const double need = memory_need(nodes, groups.value_or(1), dimension);
  const std::string under =
      groups ? fmt::format(" under {} group{} of supports", *groups, *groups == 1 ? "" : "s") : "";
  throw InputError(source,
                   fmt::format("{} nodes{} need {} {:.2g} GB of memory, more than three quarters of the {:.2g} GB that "
                               "there are; take fewer nodes",
                               nodes, under, groups ? "about" : "at least", need / kGigabyte, memory / kGigabyte));
}

double control_group_memory(const fs::path& membership, const fs::path& root) {
  double limit = std::numeric_limits<double>::infinity();
  std::ifstream groups(membership);
  for (std::string line; std::getline(groups, line);) {
    if (!line.starts_with("0::/")) continue;  // version 1, or a controller that isn't mounted so
    // Inside a container the root is the container's own group, whatever its name is outside: a limit there holds, too.
    for (fs::path group = fs::path(line.substr(4)).relative_path();; group = group.parent_path()) {
      double most = 0.0;
      std::ifstream file(root / group / "memory.max");
      if (file >> most) limit = std::min(limit, most);  // "max" is no number: no limit
      if (group.empty()) break;
    }
  }
  return limit;
}

double available_memory() {
  double limit = control_group_memory("/proc/self/cgroup", "/sys/fs/cgroup");
  rlimit of_process{};
  if (::getrlimit(RLIMIT_AS, &of_process) == 0 && of_process.rlim_cur != RLIM_INFINITY)
    limit = std::min(limit, static_cast<double>(of_process.rlim_cur));
  const long pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || size <= 0) return limit;
  return std::min(limit, static_cast<double>(pages) * static_cast<double>(size));
}

}  // namespace nodal::elastic
