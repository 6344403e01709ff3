// SPDX-License-Identifier: GPL-3.0-or-later
#include "truncated_cg.h"

#include <algorithm>
#include <utility>

#include "vectors.h"

namespace nodal::gauss_newton {

TruncatedCg::TruncatedCg(Meter& meter, std::size_t pairs) : meter_(meter), seen_(pairs), used_(pairs) {
  for (std::vector<double>* v : {&gradient_, &last_gradient_, &free_gradient_, &scaled_, &d_, &change_})
    v->resize(meter.space().size());
  for (std::vector<double>* v : {&jd_, &j_change_}) v->resize(meter.residual_count());
  fixed_.resize(meter.space().size());
}

void TruncatedCg::begin(std::span<const double> residuals, std::span<const double> gradient, const Box& box,
                        Step& step) {
  std::ranges::copy(gradient, gradient_.begin());
  step.p.assign(gradient.size(), 0.0);
  step.residuals.assign(residuals.begin(), residuals.end());
  step.iterations = 0;
  step.at_side = false;
  for (std::size_t i = 0; i < fixed_.size(); ++i)
    fixed_[i] = (gradient[i] >= 0.0 && box.lower[i] >= 0.0) || (gradient[i] <= 0.0 && box.upper[i] <= 0.0);
  used_ = seen_;
  slope_ = 0.0;
}

Status TruncatedCg::solve(std::span<const double> residuals, std::span<const double> gradient, const Box& box,
                          const CgLimits& limits, Step& step) {
  begin(residuals, gradient, box, step);
  const double start = dot(residuals, residuals);
  double gained = 0.0;
  for (;;) {
    if (const Status status = turn(); status != Status::ok) return status;
    if (!(length_ > 0.0)) return Status::ok;
    const bool inside = fits(box, step);
    if (inside) {
      add(length_, d_, step.p);
      add(length_, jd_, step.residuals);
    } else if (const Status status = stop_at_sides(box, step); status != Status::ok) {
      return status;
    }
    ++step.iterations;
    const double total = start - dot(step.residuals, step.residuals);
    const double gain = total - std::exchange(gained, total);
    if (step.iterations >= limits.max_iterations || step.iterations * gain <= limits.tolerance * total)
      return Status::ok;
    if (const Status status = renew_gradient(step, inside); status != Status::ok) return status;
  }
}

// The next direction, J times it, and how far along it the model falls.
Status TruncatedCg::turn() {
  for (std::size_t i = 0; i < fixed_.size(); ++i) free_gradient_[i] = fixed_[i] ? 0.0 : gradient_[i];
  used_.apply(free_gradient_, scaled_);
  for (std::size_t i = 0; i < fixed_.size(); ++i) scaled_[i] = fixed_[i] ? 0.0 : -scaled_[i];
  const double last = std::exchange(slope_, -dot(free_gradient_, scaled_));
  const double keep = last > 0.0 ? slope_ / last : 0.0;
  for (std::size_t i = 0; i < d_.size(); ++i) d_[i] = scaled_[i] + keep * d_[i];
  length_ = 0.0;
  if (!(slope_ > 0.0)) return Status::ok;
  const Status status = meter_.jacobian_product(d_, jd_);
  const double curvature = dot(jd_, jd_);
  if (status == Status::ok && curvature > 0.0) length_ = slope_ / curvature;
  return status;
}

bool TruncatedCg::fits(const Box& box, const Step& step) const {
  for (std::size_t i = 0; i < d_.size(); ++i) {
    const double there = step.p[i] + length_ * d_[i];
    if (!fixed_[i] && (there < box.lower[i] || there > box.upper[i])) return false;
  }
  return true;
}

// Goes the whole length with all that runs out of the box stopped at its sides, if the model is lower there; else to
// the first side.
Status TruncatedCg::stop_at_sides(const Box& box, Step& step) {
  double first = length_;
  for (std::size_t i = 0; i < d_.size(); ++i) {
    change_[i] = 0.0;
    if (fixed_[i] || d_[i] == 0.0) continue;
    change_[i] = std::clamp(step.p[i] + length_ * d_[i], box.lower[i], box.upper[i]) - step.p[i];
    first = std::clamp(((d_[i] > 0.0 ? box.upper[i] : box.lower[i]) - step.p[i]) / d_[i], 0.0, first);
  }
  if (const Status status = meter_.jacobian_product(change_, j_change_); status != Status::ok) return status;
  const bool lower = 2.0 * dot(step.residuals, j_change_) + dot(j_change_, j_change_) < 0.0;
  add(lower ? 1.0 : 0.0, j_change_, step.residuals);
  add(lower ? 0.0 : first, jd_, step.residuals);
  for (std::size_t i = 0; i < d_.size(); ++i) {
    if (fixed_[i] || d_[i] == 0.0) continue;
    const double side = d_[i] > 0.0 ? box.upper[i] : box.lower[i];
    const double length = lower ? length_ : first;
    const bool stopped = (side - step.p[i]) / d_[i] <= length;
    step.p[i] = stopped ? side : step.p[i] + length * d_[i];
    fixed_[i] = stopped;
  }
  step.at_side = true;
  return Status::ok;
}

// What the last step along d says about JᵀJ is remembered; after a stop at the sides the directions begin anew.
Status TruncatedCg::renew_gradient(const Step& step, bool remember) {
  std::swap(gradient_, last_gradient_);
  const Status status = meter_.jacobian_transposed_product(step.residuals, gradient_);
  if (!remember) slope_ = 0.0;
  if (status != Status::ok || !remember) return status;
  for (std::size_t i = 0; i < d_.size(); ++i) {
    scaled_[i] = length_ * d_[i];
    change_[i] = gradient_[i] - last_gradient_[i];
  }
  seen_.add(scaled_, change_);
  return status;
}

}  // namespace nodal::gauss_newton
