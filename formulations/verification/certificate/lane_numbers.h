#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace desmo {

/// Four numbers in a register, one for each of four equal blocks. Operations act lane by lane.
/// std::experimental::simd would not do. In GCC 12 its fma() is scalar in some loops, its max()
/// assumes that there is no NaN, and its sin() and cos() are rounded otherwise than those of
/// <cmath>.
struct LaneNumbers {
  static constexpr int count = 4;
  using Numbers [[gnu::vector_size(32)]] = double;
  using Bits [[gnu::vector_size(32)]] = long long;

  Numbers v{};

  LaneNumbers() = default;
  LaneNumbers(double same) : v{same, same, same, same} {}
  LaneNumbers(const Numbers& numbers) : v(numbers) {}
  double operator[](int lane) const { return v[lane]; }
  void set(int lane, double x) { v[lane] = x; }

  friend LaneNumbers operator-(const LaneNumbers& a) { return -a.v; }
  friend LaneNumbers operator+(const LaneNumbers& a, const LaneNumbers& b) { return a.v + b.v; }
  friend LaneNumbers operator-(const LaneNumbers& a, const LaneNumbers& b) { return a.v - b.v; }
  friend LaneNumbers operator*(const LaneNumbers& a, const LaneNumbers& b) { return a.v * b.v; }
  friend LaneNumbers operator/(const LaneNumbers& a, const LaneNumbers& b) { return a.v / b.v; }
  LaneNumbers& operator+=(const LaneNumbers& a) { return v += a.v, *this; }
  LaneNumbers& operator*=(const LaneNumbers& a) { return v *= a.v, *this; }

  friend LaneNumbers abs(const LaneNumbers& a) {
    return (Numbers)((Bits)a.v & (Bits{} + 0x7fff'ffff'ffff'ffff));
  }
  /// Return the smaller and the larger number; b where one of them is not a number.
  friend LaneNumbers min(const LaneNumbers& a, const LaneNumbers& b) {
    return a.v < b.v ? a.v : b.v;
  }
  friend LaneNumbers max(const LaneNumbers& a, const LaneNumbers& b) {
    return a.v > b.v ? a.v : b.v;
  }
  /// Returns a b + c, rounded once.
  friend LaneNumbers fma(const LaneNumbers& a, const LaneNumbers& b, const LaneNumbers& c) {
#ifdef __FMA__
    return (Numbers)_mm256_fmadd_pd(a.v, b.v, c.v);
#else
    return of_each([](double x, double y, double z) { return std::fma(x, y, z); }, a, b, c);
#endif
  }
  friend LaneNumbers sin(const LaneNumbers& a) {
    return a.are_same() ? LaneNumbers(std::sin(a[0]))
                        : of_each([](double x) { return std::sin(x); }, a);
  }
  friend LaneNumbers cos(const LaneNumbers& a) {
    return a.are_same() ? LaneNumbers(std::cos(a[0]))
                        : of_each([](double x) { return std::cos(x); }, a);
  }

  /// Returns whether all lanes have the same bits, as those of a batch that repeats a single block.
  bool are_same() const {
    const Bits bits = (Bits)v;
    return ((bits[0] ^ bits[1]) | (bits[0] ^ bits[2]) | (bits[0] ^ bits[3])) == 0;
  }

  static LaneNumbers load(const double* from) {
    LaneNumbers x;
    __builtin_memcpy(&x.v, from, sizeof x.v);
    return x;
  }
  /// Returns x[first] … x[first + 3]; zeros after the last number of x.
  static LaneNumbers load(std::span<const double> x, std::size_t first) {
    if (first + count <= x.size()) return load(&x[first]);
    LaneNumbers some;
    for (std::size_t i = first; i < x.size(); ++i) some.set(static_cast<int>(i - first), x[i]);
    return some;
  }
  void store(double* to) const { __builtin_memcpy(to, &v, sizeof v); }

  /// Applies a function lane by lane.
  template <class Function, class... Arguments>
  static LaneNumbers of_each(Function&& function, const Arguments&... arguments) {
    LaneNumbers result;
    for (int lane = 0; lane < count; ++lane) result.v[lane] = function(arguments.v[lane]...);
    return result;
  }
};

/// A truth value in each of four lanes.
struct LaneMask {
  LaneNumbers::Bits bits{};

  static LaneMask all() { return {LaneNumbers::Bits{} - 1}; }
  static LaneMask only(int lane) {
    LaneMask m;
    m.bits[lane] = -1;
    return m;
  }
  bool operator[](int lane) const { return bits[lane] != 0; }
  bool any() const {
#ifdef __AVX__
    return _mm256_movemask_pd((__m256d)bits) != 0;
#else
    return (bits[0] | bits[1] | bits[2] | bits[3]) != 0;
#endif
  }
  friend LaneMask operator&(LaneMask a, LaneMask b) { return {a.bits & b.bits}; }
  friend LaneMask operator|(LaneMask a, LaneMask b) { return {a.bits | b.bits}; }
  friend LaneMask operator!(LaneMask a) { return {~a.bits}; }
};

/// Returns where a is less than b: false where one of them is not a number.
inline LaneMask less(const LaneNumbers& a, const LaneNumbers& b) {
  return {(LaneNumbers::Bits)(a.v < b.v)};
}
inline LaneMask is_zero(const LaneNumbers& a) {
  return {(LaneNumbers::Bits)(a.v == LaneNumbers(0).v)};
}
inline LaneMask is_finite(const LaneNumbers& a) { return less(abs(a), INFINITY); }
/// Returns a where the mask is true, elsewhere b.
inline LaneNumbers select(LaneMask mask, const LaneNumbers& a, const LaneNumbers& b) {
  return mask.bits ? a.v : b.v;
}

/// Transposes a 4 × 4 matrix, whose rows these are.
inline void transpose(LaneNumbers& a, LaneNumbers& b, LaneNumbers& c, LaneNumbers& d) {
  using Pick = LaneNumbers::Bits;
  constexpr Pick even{0, 4, 2, 6}, odd{1, 5, 3, 7}, low{0, 1, 4, 5}, high{2, 3, 6, 7};
  const LaneNumbers::Numbers ab0 = __builtin_shuffle(a.v, b.v, even),
                             ab1 = __builtin_shuffle(a.v, b.v, odd),
                             cd0 = __builtin_shuffle(c.v, d.v, even),
                             cd1 = __builtin_shuffle(c.v, d.v, odd);
  a.v = __builtin_shuffle(ab0, cd0, low);
  b.v = __builtin_shuffle(ab1, cd1, low);
  c.v = __builtin_shuffle(ab0, cd0, high);
  d.v = __builtin_shuffle(ab1, cd1, high);
}

}  // namespace desmo
