// SPDX-License-Identifier: GPL-3.0-or-later
#include "stop_signal.h"

namespace nodal {

namespace {

std::atomic<bool> stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

extern "C" void ask_to_stop(int) { stop_asked.store(true); }

}  // namespace

StopSignal::StopSignal() {
  stop_asked = false;
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  sigaction(SIGINT, &action, &former_interrupt_);
  sigaction(SIGTERM, &action, &former_terminate_);
  sigaction(SIGHUP, nullptr, &former_hang_up_);
  if (former_hang_up_.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // nohup means it
}

StopSignal::~StopSignal() {
  sigaction(SIGINT, &former_interrupt_, nullptr);
  sigaction(SIGTERM, &former_terminate_, nullptr);
  sigaction(SIGHUP, &former_hang_up_, nullptr);
}

const std::atomic<bool>& StopSignal::flag() const noexcept { return stop_asked; }

}  // namespace nodal
