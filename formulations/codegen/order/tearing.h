#pragma once

#include <bitset>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "formulations/codegen/order/closed_form.h"

namespace desmo::generate {

/// A closed form with its unknowns and equations, as positions in the lists of a Tearing.
struct PlacedForm {
  ClosedForm form;
  std::vector<int> unknowns, equations;
};

/// An order of closed forms that holds once some unknowns are torn, that is, assumed to be known.
struct TornOrder {
  std::vector<int> torn;
  std::vector<PlacedForm> placed;
  std::vector<int> left_over;  ///< equations for Newton–Raphson on the torn unknowns
  int unplaced = 0;            ///< number of unknowns that no closed form reaches
  double quality = 1;          ///< smallest quality of its closed forms
  int cost = 0;                ///< sum of ClosedForm::cost
};

/// A search for explicit orders of n equations for n unknowns. Up to four equations are solved
/// together, provided that a rule applies and their quality is ≥ 0.03; for all n equations, > 0 is
/// enough. The *quality* of equations that are solved together for unknowns x is their distance
/// from singularity: the smallest |det ∂Φ/∂x| over the sample points. There each equation is
/// divided by the length of its gradient by all n unknowns.
class Tearing {
 public:
  /// Differentiates the equations by the unknowns. facts must outlive the object. Throws
  /// std::invalid_argument when there are more than `max_unknowns` unknowns.
  Tearing(std::vector<Expr> equations, std::vector<Expr> unknowns, const Facts& facts);

  /// Returns the best order found, with few torn unknowns. Sets of up to three are searched
  /// exhaustively unless there are too many. Otherwise a greedy search tears, one after the other,
  /// the unknown that helps most.
  TornOrder best();

  static constexpr std::size_t max_unknowns = 256;

 private:
  using Set = std::bitset<max_unknowns>;
  struct Walk {
    Set open;                // unknowns not yet placed
    std::vector<bool> used;  // whether each equation is in a closed form
    std::vector<Set> reads;  // open unknowns that each equation reads
  };

  /// The outcome of solving n equations for n unknowns.
  struct Match {
    std::optional<ClosedForm> form;  // nullopt: no rule applies, or quality is zero
    double quality = 0;
  };

  const Match& match(const std::vector<int>& unknowns, const std::vector<int>& equations);
  double quality(const std::vector<int>& unknowns, const std::vector<int>& equations) const;
  TornOrder walk(const std::vector<int>& torn);
  bool place_next(Walk& walk, TornOrder& order);
  bool extend(Walk& walk, TornOrder& order, std::vector<int>& equations, const Set& unknowns,
              std::size_t size);
  std::optional<TornOrder> best_of_size(std::size_t size);
  TornOrder greedy();

  std::vector<Expr> equations_, unknowns_;
  const Facts& facts_;
  // ∂equation/∂unknown at each sample point, for each equation, by the unknowns that it reads.
  std::vector<std::map<int, std::vector<double>>> slopes_;
  std::vector<Set> reads_;  // unknowns that each equation reads
  // Matches found so far, by unknowns and equations.
  std::map<std::pair<std::vector<int>, std::vector<int>>, Match> matches_;
};

}  // namespace desmo::generate
