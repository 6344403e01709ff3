// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Numbers aligned for the widest vector register, all zero at first. Never grows. std::bad_alloc.

#include <cstddef>
#include <memory>
#include <new>
#include <span>

namespace nodal::elastic {

class AlignedArray {
 public:
  AlignedArray() = default;
  explicit AlignedArray(std::size_t size)
      : numbers_(static_cast<double*>(::operator new[](size * sizeof(double), kAlignment))), size_(size) {
    std::uninitialized_fill_n(numbers_.get(), size, 0.0);
  }

  [[nodiscard]] double* data() noexcept { return numbers_.get(); }
  [[nodiscard]] const double* data() const noexcept { return numbers_.get(); }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] double& operator[](std::size_t i) noexcept { return numbers_[i]; }
  [[nodiscard]] double operator[](std::size_t i) const noexcept { return numbers_[i]; }

 private:
  static constexpr std::align_val_t kAlignment{64};
  struct Free {
    void operator()(double* numbers) const { ::operator delete[](numbers, kAlignment); }
  };
  std::unique_ptr<double[], Free> numbers_;
  std::size_t size_ = 0;
};

}  // namespace nodal::elastic
