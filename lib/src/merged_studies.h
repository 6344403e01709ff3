// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The studies of stores that are put together: which of them differ, and whether their figures compare.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nodal/value.h>

namespace nodal {

class MergedStudies {
 public:
  /// The study of a store's manifest, and those that it was merged from. InputError where a problem of the same label
  /// has another budget or other starts than in a store before. Warns of other texts, settings and seeds.
  void add(const Value& manifest, const std::string& directory, std::vector<std::string>& warnings);
  /// Sets `study` and, where there are others, `other_studies`.
  void write_to(Value& manifest) const;

 private:
  // Under what a problem was raced.
  struct Terms {
    std::string directory;
    Value budget, starts;
  };
  void add_study(const Value& study, const std::string& directory, std::vector<std::string>& warnings);
  void require_same_terms(const Value& study, const std::string& directory, std::vector<std::string>& warnings);

  Value::List studies_;  // each once
  std::string first_directory_;
  std::map<std::string, Terms> terms_;  // by the problem's label
};

}  // namespace nodal
