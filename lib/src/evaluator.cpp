// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/evaluator.h>

#include <stdexcept>

namespace nodal {

// An optimizer whose needs are declared never gets here: a study that lacks an ability is refused when it is read.

Status Evaluator::held_out_errors(std::span<const double>, std::span<double> errors) {
  if (!errors.empty()) throw std::logic_error("this problem holds nothing out");
  return Status::ok;
}
Evaluation Evaluator::value_and_gradient(std::span<const double>, std::span<double>) {
  throw std::logic_error("this problem has no gradient");
}
Evaluation Evaluator::residuals(std::span<const double>, std::span<double>) {
  throw std::logic_error("this problem has no residuals");
}
Evaluation Evaluator::residuals_and_jacobian(std::span<const double>, std::span<double>, std::span<double>) {
  throw std::logic_error("this problem has no residuals");
}
Status Evaluator::gradient(std::span<double>) { throw std::logic_error("this problem has no gradient"); }
Status Evaluator::jacobian(std::span<double>) { throw std::logic_error("this problem has no residuals"); }
Status Evaluator::jacobian_product(std::span<const double>, std::span<double>) {
  throw std::logic_error("this problem has no Jacobian products");
}
Status Evaluator::jacobian_transposed_product(std::span<const double>, std::span<double>) {
  throw std::logic_error("this problem has no Jacobian products");
}

}  // namespace nodal
