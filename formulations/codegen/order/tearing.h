#pragma once

#include <bitset>
#include <optional>
#include <vector>

#include "formulations/codegen/order/matcher.h"

namespace desmo::generate {

/// A closed form and what it is for, as positions in lists of unknowns and equations.
struct Placed {
  ClosedForm form;
  std::vector<int> unknowns, equations;
};

/// An order in which unknowns follow one after the other once some are torn, that is taken as
/// known. Equations left over are what Newton–Raphson on the torn ones has to satisfy.
struct Torn {
  std::vector<int> torn;
  std::vector<Placed> placed;
  std::vector<int> left_over;
  int unplaced = 0;    ///< unknowns that the order does not reach
  double quality = 1;  ///< the smallest determinant of a closed form, of normalised equations
  int cost = 0;        ///< of the closed forms
};

/// Finds explicit orders of as many equations as unknowns. Sets of up to four equations with as
/// many unknowns left are solved as one where a rule applies and where, at every sample point,
/// their determinant is not small (Match::quality).
class Tearing {
 public:
  /// facts must outlive it. More than `max_unknowns` throw std::invalid_argument.
  Tearing(const std::vector<Expr>& equations, const std::vector<Expr>& unknowns,
          const Facts& facts);

  /// With as few torn unknowns as were found: up to three by trying all, more by always tearing the
  /// one that frees most.
  Torn best();

  static constexpr std::size_t max_unknowns = 256;

 private:
  using Set = std::bitset<max_unknowns>;
  struct Walk {
    Set open;                // unknowns not yet placed
    std::vector<bool> used;  // equations
    std::vector<Set> reads;  // of each equation, among the open ones
  };

  Torn walk(const std::vector<int>& torn);
  bool place_next(Walk& walk, Torn& order);
  bool extend(Walk& walk, Torn& order, std::vector<int>& equations, const Set& unknowns,
              std::size_t size);
  std::optional<Torn> best_of_size(std::size_t size);
  Torn greedy();

  std::size_t unknowns_;  // how many
  Matcher matcher_;
  std::vector<Set> reads_;  // of each equation
};

}  // namespace desmo::generate
