// Real numbers in the balls of Arb (Johansson, IEEE Trans. Comput. 66, 2017), with 256 bits.
#pragma once

#include <arb.h>

#include "cases/numbers/derived.h"

namespace desmo::arb_test {

inline constexpr slong bits = 256;

/// A real number that lies in a ball.
class Ball {
 public:
  Ball(double exact = 0) {
    arb_init(x_);
    arb_set_d(x_, exact);
  }
  explicit Ball(const Derived& x) : Ball(x.value) {
    *this = *this + Ball(x.correction);
    Ball radius(x.radius);
    arb_add_error(x_, radius.x_);
  }
  Ball(const Ball& a) {
    arb_init(x_);
    arb_set(x_, a.x_);
  }
  Ball& operator=(const Ball& a) {
    arb_set(x_, a.x_);
    return *this;
  }
  ~Ball() { arb_clear(x_); }

  arb_ptr get() { return x_; }
  arb_srcptr get() const { return x_; }
  /// Returns an upper bound of the distance from a number.
  double distance(const Ball& from) const {
    const Ball d = *this - from;
    arf_t bound;
    arf_init(bound);
    arb_get_abs_ubound_arf(bound, d.x_, bits);
    const double result = arf_get_d(bound, ARF_RND_UP);
    arf_clear(bound);
    return result;
  }

  friend Ball operator-(const Ball& a) {
    return with(a, a, [](auto z, auto x, auto) { arb_neg(z, x); });
  }
  friend Ball operator+(const Ball& a, const Ball& b) {
    return with(a, b, [](auto z, auto x, auto y) { arb_add(z, x, y, bits); });
  }
  friend Ball operator-(const Ball& a, const Ball& b) {
    return with(a, b, [](auto z, auto x, auto y) { arb_sub(z, x, y, bits); });
  }
  friend Ball operator*(const Ball& a, const Ball& b) {
    return with(a, b, [](auto z, auto x, auto y) { arb_mul(z, x, y, bits); });
  }
  friend Ball operator/(const Ball& a, const Ball& b) {
    return with(a, b, [](auto z, auto x, auto y) { arb_div(z, x, y, bits); });
  }
  friend Ball sqrt(const Ball& a) {
    return with(a, a, [](auto z, auto x, auto) { arb_sqrt(z, x, bits); });
  }
  friend Ball sin(const Ball& a) {
    return with(a, a, [](auto z, auto x, auto) { arb_sin(z, x, bits); });
  }
  friend Ball cos(const Ball& a) {
    return with(a, a, [](auto z, auto x, auto) { arb_cos(z, x, bits); });
  }

 private:
  template <class Function>
  static Ball with(const Ball& a, const Ball& b, Function&& function) {
    Ball z;
    function(z.x_, a.x_, b.x_);
    return z;
  }
  arb_t x_;
};

}  // namespace desmo::arb_test
