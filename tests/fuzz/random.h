#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

namespace desmo::fuzz {

/// The exception of Random::pick for an empty list.
struct NothingToPick {};

/// The random generator SplitMix64. It gives the same numbers on every machine, unlike the
/// distributions of the standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  /// Returns an integer from 0 to n - 1; 0 when n is 0.
  std::size_t below(std::size_t n) { return n == 0 ? 0 : next() % n; }
  bool one_in(std::size_t n) { return below(n) == 0; }
  /// Returns a number from -1 to 1.
  double around_zero() { return static_cast<double>(next() >> 11) * 0x1p-52 - 1; }

  /// Returns an element of a list. Throws NothingToPick when the list is empty.
  template <class List>
  decltype(auto) pick(List& list) {
    if (std::size(list) == 0) throw NothingToPick();
    return *std::next(std::begin(list), static_cast<std::ptrdiff_t>(below(std::size(list))));
  }

 private:
  std::uint64_t state_;
};

}  // namespace desmo::fuzz
