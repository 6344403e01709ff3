// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The methods of NLopt that race here, as data: adding one adds a row.

#include <nlopt.h>

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace nodal::nlopt_methods {

/// How the library sizes a population (of MLSL: the points sampled per iteration) unless told.
struct Population {
  unsigned constant = 0;
  unsigned per_freedom = 0;  ///< times (coordinates + 1)

  [[nodiscard]] bool used() const noexcept { return constant + per_freedom > 0; }
  [[nodiscard]] unsigned size(std::size_t coordinates) const noexcept {
    return constant + per_freedom * (static_cast<unsigned>(coordinates) + 1);
  }
};

/// Which methods may polish the samples of a multi-level search.
enum class LocalSearch { none, values, gradients };

struct Method {
  std::string_view name;  ///< as `use` names it
  nlopt_algorithm algorithm = NLOPT_NUM_ALGORITHMS;
  std::string_view summary, reference;
  bool needs_gradient = false;
  bool deterministic = true;  ///< draws nothing from the library's generator
  bool uses_start = true;
  bool local = false;
  Population population = {};
  bool dense_model = false;     ///< holds a matrix of coordinates × coordinates
  bool vector_storage = false;  ///< remembers steps and gradients: one of Luksan's methods
  bool initial_step = false;    ///< without derivatives: the first step tells the scale
  LocalSearch local_search = LocalSearch::none;
};

[[nodiscard]] std::span<const Method> all_methods();
/// By name without "nlopt-"; std::logic_error for none.
[[nodiscard]] const Method& find_method(std::string_view short_name);
/// Short names of the local methods that a multi-level search may use.
[[nodiscard]] std::vector<std::string_view> local_methods(LocalSearch kind);

/// A method of NLopt that is left out, and why.
struct LeftOutMethod {
  std::string_view name, reason;
};
[[nodiscard]] std::span<const LeftOutMethod> left_out_methods();

}  // namespace nodal::nlopt_methods
