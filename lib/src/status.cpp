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

namespace {

std::string_view meaning(Status status) noexcept {
  switch (status) {
    case Status::ok:
      return "it can be evaluated";
    case Status::not_positive_definite:
      return "the system can't carry its loads";
    case Status::ill_conditioned:
      return "double precision can't vouch for the result";
    case Status::invalid_input:
      return "a coordinate or the cost is no finite number";
    case Status::budget_spent:
      return "the budget was spent before";
  }
  return "nobody knows why";
}

}  // namespace

std::string in_words(Status status) {
  return std::string(meaning(status)) + " (" + std::string(to_string(status)) + ")";
}

}  // namespace nodal
