#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "formulations/codegen/order/closed_form.h"

namespace desmo::generate {

/// The outcome of solving n equations for n unknowns.
struct Match {
  std::optional<ClosedForm> form;  ///< nullopt: no rule applies, or quality is zero
  /// Distance from singularity: the smallest |det ∂Φ/∂x| over the sample points, of equations with
  /// gradients of unit length.
  double quality = 0;
};

/// A cached search for closed forms. Equations and unknowns are given as positions in the lists of
/// the constructor.
class Matcher {
 public:
  /// Differentiates the equations by the unknowns. facts must outlive the matcher.
  Matcher(std::vector<Expr> equations, std::vector<Expr> unknowns, const Facts& facts);

  /// Returns a closed form for a set. Both lists are ascending and of one size. The reference is
  /// valid as long as the matcher.
  const Match& match(const std::vector<int>& unknowns, const std::vector<int>& equations);

  /// Returns the unknowns that an equation reads, ascending.
  std::vector<int> read_by(int equation) const;

 private:
  double quality(const std::vector<int>& unknowns, const std::vector<int>& equations) const;

  std::vector<Expr> equations_, unknowns_;
  const Facts& facts_;
  std::vector<std::map<int, std::vector<double>>> slopes_;  // ∂equation/∂unknown at each sample
  std::map<std::pair<std::vector<int>, std::vector<int>>, Match> matches_;
};

}  // namespace desmo::generate
