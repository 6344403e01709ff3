// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What reading a study of toys complains of.

#include <string>
#include <string_view>

#include "../../support/messages.h"
#include "../toy_study.h"

namespace nodal::toy {

inline std::string refusal(std::string_view text, const StudyOverrides& overrides = {}) {
  return message_of([&] { (void)study(text, overrides); });
}

/// After two lines that are right.
inline std::string refusal_after_problem(const std::string& text, const StudyOverrides& overrides = {}) {
  return refusal("[problem]\nkind = \"bowl\"\n" + text, overrides);
}

}  // namespace nodal::toy
