// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/status.h>

namespace nodal {

std::string_view to_string(Status status) noexcept {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::not_positive_definite:
      return "not_positive_definite";
    case Status::ill_conditioned:
      return "ill_conditioned";
    case Status::invalid_input:
      return "invalid_input";
    case Status::budget_spent:
      return "budget_spent";
  }
  return "unknown";
}

}  // namespace nodal
