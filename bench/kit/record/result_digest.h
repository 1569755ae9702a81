#pragma once

#include <cstdint>
#include <string>

#include "formulations/runtime/digest.h"

namespace desmo::bench {

/// The multiple of `unit` next to a value. Within one unit of the reference, a value counts as the
/// reference, so that equally right results never round apart, wherever they lie; further away, the
/// two do not round alike. What is no number, or beyond 10¹⁸ units, is one and the same multiple.
std::int64_t rounded(double value, double reference, double unit);

/// Digest of results, each rounded to what it may differ from the reference: that of the reference
/// itself when every value is within it, another when one is not.
class ResultDigest {
 public:
  void add(double value, double reference, double unit);
  std::string hex() { return digest_.hex(); }

 private:
  Digest digest_;
};

}  // namespace desmo::bench
