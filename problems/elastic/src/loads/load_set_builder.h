// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Puts loads that share their supports, and what is measured of them, into one support group: one factorization.

#include <string>
#include <vector>

#include <nodal/elastic/loads.h>

namespace nodal::elastic {

class LoadSetBuilder {
 public:
  explicit LoadSetBuilder(const Freedoms& freedoms) : freedoms_(freedoms) {}

  /// The group's supports in any order, each freedom once; the reference is what they say where they hold.
  void add(std::string name, std::vector<double> forces, std::vector<double> reference, SupportGroup group);
  /// The same of a load whose own group is another set's.
  void add(LoadCase load, SupportGroup group);
  /// A load of another set.
  void add(const LoadSet& set, std::size_t load);

  [[nodiscard]] LoadSet finish() && { return std::move(set_); }

 private:
  Freedoms freedoms_;
  LoadSet set_;
};

}  // namespace nodal::elastic
