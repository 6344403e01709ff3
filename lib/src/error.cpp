// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/error.h>

#include <algorithm>

#include <nodal/shown.h>

#include "escaped.h"

namespace nodal {

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

// what() ends at the first NUL, which a quoted text may hold: shown as TOML and JSON write it, it loses nothing.
std::string uncut(std::string text) {
  for (std::size_t at = text.find('\0'); at != std::string::npos; at = text.find('\0', at))
    text.replace(at, 1, escaped(std::string_view("\0", 1)));
  return text;
}

std::string quoted_list(std::span<const std::string> names, const char* last_separator) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? last_separator : ", ";
    text += "'" + shown(names[i]) + "'";
  }
  return text;
}

}  // namespace

std::string Source::text() const {
  if (file.empty()) return {};
  return line > 0 ? file + ":" + std::to_string(line) : file;
}

InputError::InputError(const Source& source, const std::string& message)
    : std::runtime_error(uncut(source.file.empty() ? message : source.text() + ": " + message)) {}

std::vector<std::string> nearest_names(std::string_view wrong, std::span<const std::string> valid) {
  constexpr std::size_t kMost = 3, kLongestName = 200;
  if (wrong.size() > kLongestName) return {};  // no slip of the pen, and the distance costs its length
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& name : valid) {
    const std::size_t distance = edit_distance(wrong, name);
    const bool completed = wrong.size() >= 3 && name.find(wrong) != std::string::npos;  // "lbfgs" for "nlopt-lbfgs"
    if (completed || distance <= std::max<std::size_t>(1, wrong.size() / 2))
      near.emplace_back(completed ? 0 : distance, name);
  }
  std::ranges::stable_sort(near, {}, &std::pair<std::size_t, std::string>::first);
  std::vector<std::string> names;
  for (const auto& [distance, name] : near)
    if (names.size() < kMost && distance <= near.front().first + 1) names.push_back(name);
  return names;
}

std::string name_hint(std::string_view wrong, std::span<const std::string> valid) {
  constexpr std::size_t kMostListed = 12;
  if (valid.empty()) return {};
  const std::vector<std::string> near = nearest_names(wrong, valid);
  if (!near.empty()) return "; did you mean " + quoted_list(near, " or ") + "?";
  const std::string more =
      valid.size() > kMostListed ? " and " + std::to_string(valid.size() - kMostListed) + " more" : "";
  return "; valid: " + quoted_list(valid.first(std::min(valid.size(), kMostListed)), ", ") + more;
}

}  // namespace nodal
