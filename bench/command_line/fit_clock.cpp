// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_clock.h"

#include <iostream>

#include <fmt/format.h>

#include "console.h"

namespace nodal {

FitClock::FitClock(bool on_terminal, std::optional<double> seconds, std::chrono::milliseconds period)
    : seconds_(seconds), period_(period) {
  if (on_terminal) thread_ = std::thread([this] { show_until_over(); });
}

FitClock::~FitClock() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  ended_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void FitClock::show_until_over() {
  const auto began = std::chrono::steady_clock::now();
  bool shown = false;
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, period_, [this] { return over_; })) {
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    send_control(std::cerr, "\r");
    std::cerr << fmt::format("{:.0f} s{}", spent, seconds_ ? fmt::format(" of at most {:g} s", *seconds_) : "");
    send_control(std::cerr, "\x1b[K");
    std::cerr << std::flush;
    shown = true;
  }
  if (shown) send_control(std::cerr, "\r\x1b[K");
  std::cerr << std::flush;
}

}  // namespace nodal
