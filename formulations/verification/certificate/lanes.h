#pragma once

#include <array>
#include <cmath>

#ifdef __FMA__
#include <immintrin.h>
#endif

namespace desmo {

/// Four numbers, one of each of four equal blocks: operations are those of each lane by itself.
struct Lanes {
  static constexpr int count = 4;
  using Numbers [[gnu::vector_size(32)]] = double;
  using Bits [[gnu::vector_size(32)]] = long long;

  Numbers v{};

  Lanes() = default;
  Lanes(double same) : v{same, same, same, same} {}
  explicit Lanes(const Numbers& numbers) : v(numbers) {}
  double operator[](int lane) const { return v[lane]; }
  void set(int lane, double x) { v[lane] = x; }

  friend Lanes operator-(const Lanes& a) { return Lanes(-a.v); }
  friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.v + b.v); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.v - b.v); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.v * b.v); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.v / b.v); }
  Lanes& operator+=(const Lanes& a) { return v += a.v, *this; }
  Lanes& operator-=(const Lanes& a) { return v -= a.v, *this; }
  Lanes& operator*=(const Lanes& a) { return v *= a.v, *this; }

  friend Lanes abs(const Lanes& a) {
    return Lanes((Numbers)((Bits)a.v & (Bits{} + 0x7fff'ffff'ffff'ffff)));
  }
  friend Lanes min(const Lanes& a, const Lanes& b) { return Lanes(a.v < b.v ? a.v : b.v); }
  friend Lanes max(const Lanes& a, const Lanes& b) { return Lanes(a.v > b.v ? a.v : b.v); }
  /// Returns a b + c, rounded once.
  friend Lanes fma(const Lanes& a, const Lanes& b, const Lanes& c) {
#ifdef __FMA__
    return Lanes((Numbers)_mm256_fmadd_pd(a.v, b.v, c.v));
#else
    return of_each([](double x, double y, double z) { return std::fma(x, y, z); }, a, b, c);
#endif
  }
  friend Lanes sin(const Lanes& a) {
    return of_each([](double x) { return std::sin(x); }, a);
  }
  friend Lanes cos(const Lanes& a) {
    return of_each([](double x) { return std::cos(x); }, a);
  }

  /// Returns a function of each lane.
  template <class Function, class... Arguments>
  static Lanes of_each(Function&& function, const Arguments&... arguments) {
    Lanes result;
    for (int lane = 0; lane < count; ++lane) result.v[lane] = function(arguments.v[lane]...);
    return result;
  }
};

/// What is true in some of four lanes.
struct LaneMask {
  Lanes::Bits bits{};

  static LaneMask all() { return {Lanes::Bits{} - 1}; }
  static LaneMask only(int lane) {
    LaneMask m;
    m.bits[lane] = -1;
    return m;
  }
  bool operator[](int lane) const { return bits[lane] != 0; }
  bool any() const { return (bits[0] | bits[1] | bits[2] | bits[3]) != 0; }
  friend LaneMask operator&(LaneMask a, LaneMask b) { return {a.bits & b.bits}; }
  friend LaneMask operator|(LaneMask a, LaneMask b) { return {a.bits | b.bits}; }
  friend LaneMask operator!(LaneMask a) { return {~a.bits}; }
};

/// Returns where a is less than b; not where one of them is not a number.
inline LaneMask less(const Lanes& a, const Lanes& b) { return {(Lanes::Bits)(a.v < b.v)}; }
inline LaneMask is_finite(const Lanes& a) { return less(abs(a), INFINITY); }
/// Returns a where the mask is true, elsewhere b.
inline Lanes select(LaneMask mask, const Lanes& a, const Lanes& b) {
  return Lanes(mask.bits ? a.v : b.v);
}

}  // namespace desmo
