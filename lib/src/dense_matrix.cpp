// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/dense_matrix.h>

#include <unistd.h>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/registry.h>

namespace nodal {

namespace {

constexpr double kGiB = 1073741824.0;

// Methods that follow derivatives and hold no such matrix: what is worth trying where there are many coordinates.
std::vector<std::string> methods_that_work(const Problem& problem, const Registry& registry) {
  std::vector<std::string> names;
  for (const OptimizerDescription& other : registry.optimizers()) {
    const bool derivatives = other.needs.gradient || other.needs.jacobian_products;
    const bool fits = dense_matrix_bytes(other.dense_matrix, problem) <= dense_matrix_limit();
    if (derivatives && fits && problem.abilities().missing(other.needs).empty()) names.push_back(other.name);
  }
  return names;
}

}  // namespace

double dense_matrix_bytes(DenseMatrix matrix, const Problem& problem) {
  const auto coordinates = static_cast<double>(problem.space().size());
  switch (matrix) {
    case DenseMatrix::none:
      return 0.0;
    case DenseMatrix::jacobian:
      return 8.0 * static_cast<double>(problem.residual_count()) * coordinates;
    case DenseMatrix::square:
      return 8.0 * coordinates * coordinates;
  }
  return 0.0;
}

double dense_matrix_limit() {
  const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::min(8.0 * kGiB, 0.25 * memory);
}

std::string dense_matrix_refusal(const OptimizerDescription& optimizer, const Problem& problem,
                                 const Registry& registry) {
  const double bytes = dense_matrix_bytes(optimizer.dense_matrix, problem);
  if (bytes <= dense_matrix_limit()) return {};
  const std::size_t coordinates = problem.space().size();
  const bool jacobian = optimizer.dense_matrix == DenseMatrix::jacobian;
  std::string too_large =
      fmt::format("needs a dense {} of {} × {} numbers, {:.1f} GiB, where at most {:.1f} GiB are reasonable",
                  jacobian ? "Jacobian" : "matrix", jacobian ? problem.residual_count() : coordinates, coordinates,
                  bytes / kGiB, dense_matrix_limit() / kGiB);
  const std::vector<std::string> others = methods_that_work(problem, registry);
  if (others.empty()) return too_large;
  return fmt::format("{}; without one work: {}", too_large, fmt::join(others, ", "));
}

}  // namespace nodal
