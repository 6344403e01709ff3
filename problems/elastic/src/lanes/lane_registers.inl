// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// N numbers in registers, as many as this instruction set's registers take.
// Part of lane_kernels.inl, which says how it is compiled.

#if defined(__FMA__)
#include <immintrin.h>
#endif

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

// a·b + c, c − a·b: rounded once where the processor can, and where it is written, since compilers are told not to
// choose by themselves (-ffp-contract=off). So equal code means equal bits.
#if defined(__FMA__)
inline double fma(double a, double b, double c) { return __builtin_fma(a, b, c); }
inline double fnma(double a, double b, double c) { return __builtin_fma(-a, b, c); }
inline __m128d fma(__m128d a, __m128d b, __m128d c) { return _mm_fmadd_pd(a, b, c); }
inline __m128d fnma(__m128d a, __m128d b, __m128d c) { return _mm_fnmadd_pd(a, b, c); }
inline __m256d fma(__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }
inline __m256d fnma(__m256d a, __m256d b, __m256d c) { return _mm256_fnmadd_pd(a, b, c); }
#if defined(__AVX512F__)
inline __m512d fma(__m512d a, __m512d b, __m512d c) { return _mm512_fmadd_pd(a, b, c); }
inline __m512d fnma(__m512d a, __m512d b, __m512d c) { return _mm512_fnmadd_pd(a, b, c); }
#endif
#else
template <class V>
V fma(V a, V b, V c) {
  return a * b + c;
}
template <class V>
V fnma(V a, V b, V c) {
  return c - a * b;
}
#endif

template <int W>
struct Register {
  typedef double type __attribute__((vector_size(8 * W), aligned(8 * W), may_alias));
};
template <>
struct Register<1> {
  using type = double;
};

constexpr int smaller(int a, int b) { return a < b ? a : b; }

// N numbers in as few registers as this instruction set allows.
template <int N>
struct Numbers {
  static constexpr int kWidth = smaller(N, NODAL_LANE_WIDTH);
  static constexpr int kParts = N / kWidth;
  using Vector = typename Register<kWidth>::type;
  Vector v[kParts];

  static Numbers load(const double* at) {
    Numbers n;
    for (int p = 0; p < kParts; ++p) n.v[p] = *reinterpret_cast<const Vector*>(at + p * kWidth);
    return n;
  }
  void store(double* at) const {
    for (int p = 0; p < kParts; ++p) *reinterpret_cast<Vector*>(at + p * kWidth) = v[p];
  }
  void keep() {
#if defined(__x86_64__)
    for (int p = 0; p < kParts; ++p) asm("" : "+v"(v[p]));
#endif
  }
  static Numbers all(double value) {
    Numbers n;
    for (int p = 0; p < kParts; ++p) n.v[p] = value - Vector{};
    return n;
  }
  double operator[](int i) const {
    if constexpr (kWidth == 1)
      return v[i];
    else
      return v[i / kWidth][i % kWidth];
  }
  double sum() const {
    Vector total = v[0];
    for (int p = 1; p < kParts; ++p) total += v[p];
    if constexpr (kWidth == 1) {
      return total;
    } else if constexpr (kWidth == 2) {
      return total[0] + total[1];
    } else if constexpr (kWidth == 4) {
      return (total[0] + total[2]) + (total[1] + total[3]);
    } else {
      return ((total[0] + total[4]) + (total[2] + total[6])) + ((total[1] + total[5]) + (total[3] + total[7]));
    }
  }
  bool above(double least) const {
    bool all_are = true;
    for (int i = 0; i < N; ++i) all_are = all_are & ((*this)[i] > least);
    return all_are;
  }
  bool positive() const { return above(0.0); }
};

template <int N>
Numbers<N> operator+(Numbers<N> a, const Numbers<N>& b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] += b.v[p];
  return a;
}
template <int N>
Numbers<N> operator-(Numbers<N> a, const Numbers<N>& b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] -= b.v[p];
  return a;
}
template <int N>
Numbers<N> operator*(Numbers<N> a, const Numbers<N>& b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] *= b.v[p];
  return a;
}
template <int N>
Numbers<N> operator/(Numbers<N> a, const Numbers<N>& b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] /= b.v[p];
  return a;
}
template <int N>
Numbers<N> fma(const Numbers<N>& a, const Numbers<N>& b, Numbers<N> c) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) c.v[p] = fma(a.v[p], b.v[p], c.v[p]);
  return c;
}
template <int N>
Numbers<N> fnma(const Numbers<N>& a, const Numbers<N>& b, Numbers<N> c) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) c.v[p] = fnma(a.v[p], b.v[p], c.v[p]);
  return c;
}
template <int N>
Numbers<N> least(Numbers<N> a, const Numbers<N>& b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] = a.v[p] < b.v[p] ? a.v[p] : b.v[p];
  return a;
}
template <int N>
Numbers<N> operator*(Numbers<N> a, double b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] *= b;
  return a;
}

}  // namespace

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
