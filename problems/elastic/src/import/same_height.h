// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is in the plane has one z: many programs write it, and it is left out. Several would be something in space.

#include <optional>
#include <string>

#include <nodal/error.h>

namespace nodal::elastic {

class SameHeight {
 public:
  /// The z of one more point, or that it has none. InputError at `source` when the others differ; `advice` ends it.
  void add(const std::optional<double>& z, const Source& source, const char* advice = "");

  /// A remark with the name of the file, without its folder: "nodes.csv: z, 5 everywhere, is left out"; empty where no
  /// point has a z.
  [[nodiscard]] std::string left_out(const std::string& file) const;

 private:
  bool first_ = true;
  std::optional<double> z_;
};

}  // namespace nodal::elastic
