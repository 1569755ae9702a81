#pragma once

#include <optional>
#include <vector>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// Σ coefficient[i] x[i] + constant, where neither contains an x.
struct Affine {
  std::vector<Expr> coefficient;
  Expr constant;
};

/// An expression as a quadratic one of some inputs x, with its products as they stand: what is
/// recorded as (x − g)² is not multiplied out, which would lose digits far from the origin.
struct Quadratic {
  struct Product {
    Expr scale;
    Affine a, b;
  };
  std::vector<Product> products;
  Affine rest;
};

/// Nothing when it is not quadratic in x, or of a form that no rule of the mechanism's equations
/// needs.
std::optional<Quadratic> expand(Expr e, const std::vector<Expr>& x);

/// cosine · cos θ + sine · sin θ + rest, where none contains θ.
struct Trigonometric {
  Expr cosine, sine, rest;
};

/// Nothing when an expression is not of this form in θ.
std::optional<Trigonometric> expand_angle(Expr e, Expr theta);

}  // namespace desmo::generate
