// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/random.h>

namespace nodal {

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key) noexcept {
  constexpr std::uint64_t kMultiplier0 = 0xD2511F53, kMultiplier1 = 0xCD9E8D57;
  constexpr std::uint32_t kWeyl0 = 0x9E3779B9, kWeyl1 = 0xBB67AE85;
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t p0 = kMultiplier0 * counter[0];
    const std::uint64_t p1 = kMultiplier1 * counter[2];
    counter = {static_cast<std::uint32_t>(p1 >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(p1),
               static_cast<std::uint32_t>(p0 >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(p0)};
    key[0] += kWeyl0;
    key[1] += kWeyl1;
  }
  return counter;
}

void RandomStream::refill() noexcept {
  const auto w = philox4x32({static_cast<std::uint32_t>(counter_), static_cast<std::uint32_t>(counter_ >> 32), 0, 0},
                            {static_cast<std::uint32_t>(key_), static_cast<std::uint32_t>(key_ >> 32)});
  words_ = {w[0] | std::uint64_t{w[1]} << 32, w[2] | std::uint64_t{w[3]} << 32};
  left_ = words_.size();
  ++counter_;
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
