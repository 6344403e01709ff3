// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/random.h>

// Integers are the same whatever multiplies them: one object serves every processor.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define NODAL_EACH_PROCESSOR __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define NODAL_EACH_PROCESSOR
#endif

namespace nodal {

namespace {

// The words of N counters side by side, each 32 bits in 64, masked where they are multiplied: so the compiler sees
// products of 32 bits and makes several at once. (From N = 16 on: fewer it unrolls into single ones.)
template <std::size_t N>
struct Counters {
  std::array<std::array<std::uint64_t, N>, 4> word;
};

template <std::size_t N>
void philox_rounds(Counters<N>& c, std::array<std::uint32_t, 2> key) noexcept {
  constexpr std::uint64_t kMultiplier0 = 0xD2511F53, kMultiplier1 = 0xCD9E8D57, kLow = 0xFFFFFFFF;
  constexpr std::uint32_t kWeyl0 = 0x9E3779B9, kWeyl1 = 0xBB67AE85;
  for (int round = 0; round < 10; ++round) {
    for (std::size_t i = 0; i < N; ++i) {
      const std::uint64_t p0 = kMultiplier0 * (c.word[0][i] & kLow), p1 = kMultiplier1 * (c.word[2][i] & kLow);
      c.word[0][i] = (p1 >> 32) ^ c.word[1][i] ^ key[0];
      c.word[1][i] = p1 & kLow;
      c.word[2][i] = (p0 >> 32) ^ c.word[3][i] ^ key[1];
      c.word[3][i] = p0 & kLow;
    }
    key[0] += kWeyl0;
    key[1] += kWeyl1;
  }
}

}  // namespace

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key) noexcept {
  Counters<1> c{};
  for (std::size_t w = 0; w < 4; ++w) c.word[w][0] = counter[w];
  philox_rounds(c, key);
  for (std::size_t w = 0; w < 4; ++w) counter[w] = static_cast<std::uint32_t>(c.word[w][0]);
  return counter;
}

NODAL_EACH_PROCESSOR void RandomStream::refill() noexcept {
  Counters<kBatch> c{};
  for (std::size_t i = 0; i < kBatch; ++i, ++counter_) {
    c.word[0][i] = counter_ & 0xFFFFFFFF;
    c.word[1][i] = counter_ >> 32;
  }
  philox_rounds(c, {static_cast<std::uint32_t>(key_), static_cast<std::uint32_t>(key_ >> 32)});
  left_ = words_.size();
  for (std::size_t i = 0; i < kBatch; ++i) {  // of each counter the second word first
    words_[left_ - 1 - 2 * i] = c.word[2][i] | c.word[3][i] << 32;
    words_[left_ - 2 - 2 * i] = c.word[0][i] | c.word[1][i] << 32;
  }
}

std::size_t RandomStream::index(std::size_t count) noexcept {
  __extension__ using Wide = unsigned __int128;
  Wide product = static_cast<Wide>((*this)()) * count;
  if (static_cast<std::uint64_t>(product) < count) {
    const std::uint64_t threshold = -static_cast<std::uint64_t>(count) % count;
    while (static_cast<std::uint64_t>(product) < threshold) product = static_cast<Wide>((*this)()) * count;
  }
  return static_cast<std::size_t>(product >> 64);
}

std::uint64_t hash64(std::string_view text) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

std::string hash128(std::string_view text) {
  __extension__ using Wide = unsigned __int128;
  constexpr Wide kPrime = (Wide{1} << 88) + 0x13b;
  Wide hash = (Wide{0x6c62272e07bb0142} << 64) + 0x62b821756295c58d;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  std::string digits(32, '0');
  for (std::size_t i = digits.size(); i-- > 0; hash >>= 4)
    digits[i] = "0123456789abcdef"[static_cast<unsigned>(hash & 15)];
  return digits;
}

}  // namespace nodal
