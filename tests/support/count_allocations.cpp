// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces the global operator new. In a file of its own, where the compiler can't see through the replacement.
#include "count_allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> count{0};
}

// Replaced too, since what it gives goes to the operator delete below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  count.fetch_add(1, std::memory_order_relaxed);
  return std::malloc(size ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace nodal {
long allocation_count() noexcept { return count.load(std::memory_order_relaxed); }
}  // namespace nodal
