#pragma once

// Constraint kinds for code that meets them while it runs: what a kind is, and its functions in one
// scalar. A visit of ConstraintKinds (constraints.h) is compiled once for each kind; only loops
// that are timed need one, and rules that differ by kind.

#include <span>
#include <string_view>
#include <vector>

namespace desmo {

/// Largest number of components of an operand: those of an orientation.
inline constexpr int max_components = 4;
/// Largest number of operands, rows, constants and Jacobian entries of a kind.
inline constexpr int max_operands = 5, max_rows = 3, max_constants = 8, max_entries = 24;

/// Place of an entry of a constraint's Jacobian.
struct EntryPlace {
  int row;
  int operand;
  int component;
};

/// Members of a kind that are no functions; constraints.h describes them.
struct KindDescription {
  std::string_view name;
  std::span<const int> operand_sizes;
  int constants;
  int rows;
  bool linear;
  int table;                        ///< position of its table among numbers; -1: it reads none
  std::vector<EntryPlace> entries;  ///< in the order in which jacobian() emits them
};

/// Returns the description of the kind at that position of ConstraintKinds. Throws
/// std::out_of_range if there is none.
const KindDescription& description_of(int kind);

/// Functions of the kind at that position of ConstraintKinds, as constraints.h describes them, in
/// double or a scalar for which kind_functions.h is included. jacobian() overwrites the values of
/// the kind's entries, in their order.
template <class S>
struct KindFunctions {
  static void residual(int kind, const S* const* x, const S* c, S* phi);
  static void jacobian(int kind, const S* const* x, const S* c, S* values);
  static void quadratic(int kind, const S* const* x, const S* const* v, const S* c, S* gamma);
};

extern template struct KindFunctions<double>;

}  // namespace desmo
