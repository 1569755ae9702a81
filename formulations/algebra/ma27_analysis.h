#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "formulations/algebra/normal_equations.h"
#include "formulations/equations/pattern.h"

namespace desmo {

/// Control and information arrays of MA27, named as in its specification, whose elements count from
/// 1.
struct Ma27Dialogue {
  std::array<int, 30> icntl;
  std::array<double, 5> cntl;
  std::array<int, 20> info{};

  /// Sets defaults for definite matrices: no search for pivots, no printing.
  Ma27Dialogue();

  /// Sets the smallest magnitude that is accepted as a pivot.
  void set_least_pivot(double size) { cntl[2] = size; }

  bool succeeded() const { return info[0] == 0; }
  bool lacks_integers() const { return info[0] == -3; }
  bool lacks_reals() const { return info[0] == -4; }
  /// Returns the size that may suffice of the memory that is lacking.
  int may_suffice() const { return info[1]; }
  /// Return the memory that the factors take without compression; exact for a definite matrix.
  int reals() const { return info[2]; }
  int integers() const { return info[3]; }
};

/// Enlarges memory to the suggested size, and at least by half, so that repetition ends. Returns
/// false when the size would exceed an int.
template <class Number>
bool grow(std::vector<Number>& memory, int may_suffice) {
  const std::size_t wanted = std::max(may_suffice, 0), more = memory.size() + memory.size() / 2 + 1;
  if (std::max(wanted, more) > std::size_t{std::numeric_limits<int>::max()}) return false;
  memory.resize(std::max(wanted, more));
  return true;
}

template <class Number>
int count(const std::vector<Number>& numbers) {
  return static_cast<int>(numbers.size());
}

/// Normal equations and MA27's order of elimination for them.
struct Ma27Analysis {
  NormalEquations normal;
  std::vector<int> row, column;  ///< row and column of each entry, counted from 1
  std::vector<int> order;        ///< IKEEP
  std::vector<int> work;         ///< IW1 of any call
  int steps = 0;
  double operations = 0;
  Ma27Dialogue dialogue;

  /// Throws std::invalid_argument when MA27 cannot analyse them.
  Ma27Analysis(const Pattern& pattern, NormalForm form);
};

/// Returns the analysis of the form that takes fewer operations.
Ma27Analysis cheapest_ma27_analysis(const Pattern& pattern);

}  // namespace desmo
