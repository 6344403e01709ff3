// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/alternating.h>

#include <time.h>

#include <algorithm>
#include <vector>

namespace nodal {

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

PairOfSeconds time_alternating(const std::function<void()>& first, const std::function<void()>& second,
                               double block_seconds, std::size_t blocks) {
  const std::size_t first_calls = calls_per_block(first, block_seconds),
                    second_calls = calls_per_block(second, block_seconds);
  std::vector<double> first_seconds, second_seconds;
  for (std::size_t b = 0; b < blocks; ++b) {
    first_seconds.push_back(seconds_of(first, first_calls) / static_cast<double>(first_calls));
    second_seconds.push_back(seconds_of(second, second_calls) / static_cast<double>(second_calls));
  }
  return {median(first_seconds), median(second_seconds)};
}

}  // namespace nodal
