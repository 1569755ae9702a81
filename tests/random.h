#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace desmo {

/// The exception of Random::pick for an empty list.
struct NothingToPick {};

/// Generator of the same numbers on every machine (SplitMix64, Steele et al. 2014), unlike the
/// distributions of the standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double uniform(double from, double to) {
    return from + (to - from) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  double log_uniform(double from, double to) {
    return std::exp(uniform(std::log(from), std::log(to)));
  }
  /// Returns an integer from 0 to n - 1; 0 when n is 0.
  template <std::integral N>
  N below(N n) {
    return n == 0 ? 0 : static_cast<N>(bits() % static_cast<std::uint64_t>(n));
  }
  bool one_in(int n) { return below(n) == 0; }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  int sign() { return chance(0.5) ? 1 : -1; }

  /// Returns an element of a list. Throws NothingToPick when the list is empty.
  template <class List>
  decltype(auto) pick(List& list) {
    if (std::size(list) == 0) throw NothingToPick();
    return *std::next(std::begin(list), static_cast<std::ptrdiff_t>(below(std::size(list))));
  }

 private:
  std::uint64_t state_;
};

}  // namespace desmo
