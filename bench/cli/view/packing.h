// Columns of numbers in little space, for a page that decodes them itself.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace desmo::cli {

/// Bytes of columns, one after the other. A number is a whole one of 32 bits: a multiple of a step,
/// or the bits of a float in its order. Of each column its second differences are stored, modulo
/// 2³², with the sign in the lowest bit, seven bits to a byte. Smooth motions have small ones.
/// data.js reads them.
class PackedColumns {
 public:
  /// Appends multiples of a step, which must fit into 32 bits.
  void add_multiples(std::span<const double> values, double step);
  /// Appends numbers rounded to single precision.
  void add_floats(std::span<const double> values);

  /// Returns all bytes, deflated (zlib) and as base64. Equal columns give equal texts.
  std::string text() const;

 private:
  void add(std::uint32_t number);

  std::vector<unsigned char> bytes_;
  std::uint32_t last_ = 0, difference_ = 0;
};

}  // namespace desmo::cli
