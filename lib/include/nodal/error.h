// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Errors that a person has to mend: a wrong study, a missing file, a full disk.
///
/// Bugs of a caller are std::logic_error or std::invalid_argument; expected numerics are returned as a Status.

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nodal {

/// Where something was said: "plate.toml:12", or "--seed" for a word of the command line. A line of 0 is not shown.
struct Source {
  std::string file;
  int line = 0;

  [[nodiscard]] std::string text() const;
};

/// Bad input: `what()` is "<file>:<line>: <what is wrong>; <what would be right>". The program exits with 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
  InputError(const Source& source, const std::string& message);
};

/// What was asked for can't be had, and why. Whoever knows where it was asked for adds that: `at`. Nobody's fault but
/// the input's: a caller's bug is another exception.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Calls f; a Refusal becomes an InputError at `source`, followed by "; <advice>" where there is any.
template <class F>
decltype(auto) at(const Source& source, F&& f, const std::string& advice = {}) {
  try {
    return std::forward<F>(f)();
  } catch (const Refusal& refusal) {
    throw InputError(source, advice.empty() ? refusal.what() : refusal.what() + ("; " + advice));
  }
}

/// A result could not be stored (disk full, folder read-only). What was stored before stays valid; exit code 2.
class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The up to three names nearest to a mistyped one, best first: edit distance at most half its length, and at most one
/// more than that of the best.
[[nodiscard]] std::vector<std::string> nearest_names(std::string_view wrong, std::span<const std::string> valid);

/// "; did you mean a or b?" from `nearest_names`; where none is near, "; valid: a, b, c": the first twelve, "and 3
/// more".
[[nodiscard]] std::string name_hint(std::string_view wrong, std::span<const std::string> valid);

}  // namespace nodal
