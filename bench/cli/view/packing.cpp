#include "bench/cli/view/packing.h"

#include <openssl/evp.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <stdexcept>

namespace desmo::cli {
namespace {

/// Maps the bits of a float to a whole number of the same order. −0 becomes 0.
std::uint32_t ordered_bits(double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  constexpr std::uint32_t sign = 0x80000000u;
  return bits & sign ? 0u - (bits & ~sign) : bits;
}

}  // namespace

void PackedColumns::add(std::uint32_t number) {
  const std::uint32_t difference = number - last_;
  const auto second = static_cast<std::int32_t>(difference - difference_);
  last_ = number;
  difference_ = difference;
  std::uint32_t rest = static_cast<std::uint32_t>(second) << 1 ^
                       static_cast<std::uint32_t>(second >> 31);  // the sign is the lowest bit
  for (; rest > 127; rest >>= 7) bytes_.push_back(static_cast<unsigned char>(rest | 128));
  bytes_.push_back(static_cast<unsigned char>(rest));
}

void PackedColumns::add_multiples(std::span<const double> values, double step) {
  last_ = difference_ = 0;
  for (const double value : values)
    add(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value / step))));
}

void PackedColumns::add_floats(std::span<const double> values) {
  last_ = difference_ = 0;
  for (const double value : values) add(ordered_bits(value));
}

std::string PackedColumns::text() const {
  uLongf size = compressBound(bytes_.size());
  std::vector<unsigned char> packed(size);
  if (compress2(packed.data(), &size, bytes_.data(), bytes_.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib has failed");
  std::string text((size + 2) / 3 * 4 + 1, '\0');
  text.resize(static_cast<std::size_t>(EVP_EncodeBlock(
      reinterpret_cast<unsigned char*>(text.data()), packed.data(), static_cast<int>(size))));
  return text;
}

}  // namespace desmo::cli
