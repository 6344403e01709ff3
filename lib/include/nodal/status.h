// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What became of one evaluation.
///
/// Numerical failure is information for the optimizer and a row for the report: it is returned, never thrown.

#include <string>
#include <string_view>

namespace nodal {

enum class Status {
  ok,
  not_positive_definite,  ///< the system can't carry its loads: a mechanism, a missing support, a negative stiffness
  ill_conditioned,        ///< solved, but double precision can't vouch for the result
  invalid_input,          ///< a coordinate, or the cost that came out, is not a finite number
  budget_spent,           ///< nothing was evaluated: the trial is over
};

/// The name as it stands in records and messages, e.g. "not_positive_definite".
[[nodiscard]] std::string_view to_string(Status status) noexcept;

/// What that means, with the name, for people: "a coordinate or the cost is no finite number (invalid_input)".
[[nodiscard]] std::string in_words(Status status);

/// One cost seen at one point. `cost` means something only when `status` is `ok`.
struct [[nodiscard]] Evaluation {
  Status status = Status::invalid_input;
  double cost = 0.0;

  [[nodiscard]] bool ok() const noexcept { return status == Status::ok; }
};

}  // namespace nodal
