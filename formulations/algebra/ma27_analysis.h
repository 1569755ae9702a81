#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "formulations/algebra/normal_equations.h"
#include "formulations/equations/pattern.h"

namespace desmo {

/// What MA27 is told and what it tells beside the matrix, by the names of its specification; there
/// elements count from 1.
struct Ma27Dialogue {
  std::array<int, 30> icntl;
  std::array<double, 5> cntl;
  std::array<int, 20> info{};

  /// For definite matrices: no pivot is searched for. MA27 prints nothing.
  Ma27Dialogue();

  /// It takes no pivot smaller than that.
  void set_least_pivot(double size) { cntl[2] = size; }

  bool succeeded() const { return info[0] == 0; }
  bool lacks_integers() const { return info[0] == -3; }
  bool lacks_reals() const { return info[0] == -4; }
  /// Of what it lacks.
  int may_suffice() const { return info[1]; }
  /// What factors take when nothing has to be moved to make room: of a definite matrix, exactly.
  int reals() const { return info[2]; }
  int integers() const { return info[3]; }
};

/// Gives memory of which there was too little what may suffice, and so much more that this comes to
/// an end. False when it would be more than can be told.
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

/// Normal equations, and the order in which MA27 eliminates them.
struct Ma27Analysis {
  NormalEquations normal;
  std::vector<int> row, column;  ///< of its entries, from 1
  std::vector<int> order;        ///< IKEEP
  std::vector<int> work;         ///< IW1, of any call
  int steps = 0;
  double operations = 0;
  Ma27Dialogue dialogue;

  /// Throws std::invalid_argument when MA27 will not analyse them.
  Ma27Analysis(const Pattern& pattern, NormalForm form);
};

/// Of the form that takes fewer operations.
Ma27Analysis cheapest_ma27_analysis(const Pattern& pattern);

}  // namespace desmo
