// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a refusal says, as a text to compare.

#include <string>

#include <nodal/error.h>

namespace nodal::toy {

/// The message of the Error that `action` throws, or "(nothing was thrown)".
template <class Error = InputError, class Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "(nothing was thrown)";
}

}  // namespace nodal::toy
