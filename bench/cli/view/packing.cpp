#include "bench/cli/view/packing.h"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace desmo::cli {
namespace {

std::string compress(std::string& bytes) {
  constexpr int gzip_window = 15 + 16, memory_level = 9;
  z_stream stream = {};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip_window, memory_level,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib cannot be used");
  std::string result(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int status = deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::runtime_error("zlib has failed");
  return result;
}

std::string base64(const std::string& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) -> unsigned {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0;
    };
    const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (int k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63];
  }
  return text;
}

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
  for (; rest > 127; rest >>= 7) bytes_ += static_cast<char>(rest | 128);
  bytes_ += static_cast<char>(rest);
}

void PackedColumns::add_multiples(std::span<const double> values, double step) {
  begin_column();
  for (const double value : values)
    add(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value / step))));
}

void PackedColumns::add_floats(std::span<const double> values) {
  begin_column();
  for (const double value : values) add(ordered_bits(value));
}

std::string PackedColumns::text() const {
  std::string bytes = bytes_;
  return base64(compress(bytes));
}

}  // namespace desmo::cli
