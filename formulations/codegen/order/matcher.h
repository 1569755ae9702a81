#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "formulations/codegen/order/closed_form.h"

namespace desmo::generate {

/// How a set of equations can be solved for as many unknowns, if by any rule.
struct Match {
  std::optional<ClosedForm> form;
  /// The determinant |∂Φ/∂x| of normalised equations, the smallest over the sample points: how far
  /// the closed form is from being singular.
  double quality = 0;
};

/// Looks for closed forms among equations and unknowns, given as positions in two lists; each set
/// is looked at once.
class Matcher {
 public:
  /// facts must outlive it.
  Matcher(std::vector<Expr> equations, std::vector<Expr> unknowns, const Facts& facts);

  /// Both ascending and of one size; valid as long as the matcher is.
  const Match& match(const std::vector<int>& unknowns, const std::vector<int>& equations);

  /// Which unknowns an equation reads, ascending.
  std::vector<int> read_by(int equation) const;

 private:
  double quality(const std::vector<int>& unknowns, const std::vector<int>& equations) const;

  std::vector<Expr> equations_, unknowns_;
  const Facts& facts_;
  std::vector<std::map<int, std::vector<double>>> slopes_;  // ∂equation/∂unknown at each sample
  std::map<std::pair<std::vector<int>, std::vector<int>>, Match> matches_;
};

}  // namespace desmo::generate
