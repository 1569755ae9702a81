#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// The affine expression Σ coefficient[i] x[i] + constant; coefficients and constant contain no x.
struct Affine {
  std::vector<Expr> coefficient;
  Expr constant;

  bool is_constant() const { return std::ranges::all_of(coefficient, &Expr::is_zero); }
};

/// A quadratic expression of some nodes x, inputs or others: Σ scale (a · b) + rest. Products stay
/// as recorded: (x − g)² is not multiplied out, because that would lose digits far from the origin.
struct Quadratic {
  struct Product {  ///< the product scale · a · b of two affine expressions
    Expr scale;
    Affine a, b;
  };
  std::vector<Product> products;
  Affine rest;
};

/// Returns e as a quadratic expression of x. Returns nullopt when e is not quadratic in x, or has a
/// form that no closed form uses.
std::optional<Quadratic> expand(Expr e, const std::vector<Expr>& x);

/// The expression cosine · cos θ + sine · sin θ + rest; none of the three contains θ.
struct Trigonometric {
  Expr cosine, sine, rest;
};

/// Returns e as a Trigonometric; nullopt when it is not recorded in that form.
std::optional<Trigonometric> expand_angle(Expr e, Expr theta);

}  // namespace desmo::generate
