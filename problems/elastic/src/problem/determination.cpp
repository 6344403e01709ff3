// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/determination.h>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/SVD>

namespace nodal::elastic {

namespace {

constexpr double kNull = 1e-9;       // of the largest singular value
constexpr double kTakesPart = 1e-6;  // squared share of a coordinate in the null space; rounding leaves 1e-13
constexpr std::size_t kMostNames = 12;

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::size_t count_measured(const Scene& scene) {
  const Freedoms freedoms = scene.net.freedoms();
  std::size_t measured = 0;
  for (const LoadCase& load : scene.loads.loads) {
    const SupportGroup& group = scene.loads.groups[load.group];
    for (std::size_t f = 0; f < load.reference.size(); ++f)
      measured +=
          scene.weight_of(freedoms.node_of(f)) * group.weight(f) > 0.0 &&
          std::ranges::none_of(group.supports, [&](const Support& s) { return freedoms.at(s.node, s.axis) == f; });
  }
  return measured;
}

// The rows of the data's Jacobian that weigh anything; empty where the point has no equilibrium.
Eigen::MatrixXd jacobian_at(const ElasticProblem& problem, std::span<const double> stiffness) {
  const auto rows = static_cast<Eigen::Index>(problem.residual_count());
  const auto columns = static_cast<Eigen::Index>(problem.parameters().size());
  std::vector<double> x(problem.parameters().size()), residuals(problem.residual_count());
  problem.parameters().coordinates(stiffness, x);
  RowMajor jacobian(rows, columns);
  const std::span<double> entries(jacobian.data(), static_cast<std::size_t>(jacobian.size()));
  if (!problem.make_evaluator()->residuals_and_jacobian(x, residuals, entries).ok()) return {};
  std::vector<Eigen::Index> kept;
  const auto of_data = static_cast<Eigen::Index>(problem.data_residual_count());
  for (Eigen::Index r = 0; r < of_data; ++r)
    if ((jacobian.row(r).array() != 0.0).any()) kept.push_back(r);
  return jacobian(kept, Eigen::all);
}

void examine(const Eigen::MatrixXd& jacobian, Determination& found) {
  found.examined = true;
  const auto columns = static_cast<Eigen::Index>(found.coordinates);
  Eigen::VectorXd determined = Eigen::VectorXd::Zero(columns);  // squared share of each coordinate in the row space
  Eigen::Index rank = 0;
  if (jacobian.rows() > 0) {
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeThinV);
    const Eigen::VectorXd& values = svd.singularValues();
    while (rank < values.size() && values[rank] > kNull * values[0]) ++rank;
    determined = svd.matrixV().leftCols(rank).rowwise().squaredNorm();
  }
  found.open = static_cast<std::size_t>(columns - rank);
  if (found.open == 0) return;
  for (Eigen::Index i = 0; i < columns; ++i)
    if (1.0 - determined[i] > kTakesPart) found.undetermined.push_back(static_cast<std::size_t>(i));
}

std::string coordinate_name(const ElasticProblem& problem, std::size_t coordinate) {
  const std::size_t e = problem.parameters().springs_of(coordinate).front();
  if (const std::string group = problem.parameters().group_name(e); !group.empty())
    return fmt::format("group '{}'", group);
  const Spring& spring = problem.net().springs[e];
  return fmt::format("({}, {})", problem.net().id(spring.first), problem.net().id(spring.second));
}

}  // namespace

Determination determine(const ElasticProblem& problem, std::span<const double> stiffness) {
  if (stiffness.size() != problem.parameters().springs())
    throw std::invalid_argument("determine: one stiffness per spring is needed");
  Determination found;
  found.coordinates = problem.parameters().size();
  if (!problem.scene().has_reference) return found;
  found.measured = count_measured(problem.scene());
  found.open = found.coordinates > found.measured ? found.coordinates - found.measured : 0;
  const double residuals = static_cast<double>(problem.data_residual_count()),
               coordinates = static_cast<double>(found.coordinates);
  if (residuals * coordinates * std::min(residuals, coordinates) > kMostDeterminationWork) return found;
  if (residuals * static_cast<double>(problem.parameters().springs()) > kMostJacobianWork) return found;
  if (problem.solve(stiffness).status != Status::ok) return found;
  examine(jacobian_at(problem, stiffness), found);
  return found;
}

namespace {

std::string what_is_open(const Determination& found) {
  const bool one = found.measured == 1, one_stiffness = found.coordinates == 1;
  const std::string stiffnesses = fmt::format("{} stiffness{}", found.coordinates, one_stiffness ? "" : "es");
  if (found.measured < found.coordinates)
    return fmt::format("{} known displacement{} can't determine {}", found.measured, one ? "" : "s", stiffnesses);
  return fmt::format("the {} known displacement{} {} determine {}{}", found.measured, one ? "" : "s",
                     one ? "doesn't" : "don't", one_stiffness ? "the " : "all ", stiffnesses);
}

}  // namespace

std::string describe(const Determination& found, const ElasticProblem& problem) {
  if (found.open == 0) return {};
  const std::string text = what_is_open(found);
  if (found.undetermined.empty()) return text;
  std::vector<std::string> names;
  for (const std::size_t i : found.undetermined)
    if (names.size() < kMostNames) names.push_back(coordinate_name(problem, i));
  const std::size_t more = found.undetermined.size() - names.size();
  const bool one = found.undetermined.size() == 1;
  return text + fmt::format(": {} {} {}, {}{}: {} can change{}, and no displacement does{}", found.undetermined.size(),
                            one ? "is" : "are", problem.scene().prior ? "the prior's alone" : "arbitrary",
                            fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "",
                            one ? "it" : "they", one ? "" : ", alone or together",
                            problem.scene().prior ? "" : "; measure more, add loads, or tie springs by 'parameters'");
}

}  // namespace nodal::elastic
