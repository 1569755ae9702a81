#include "formulations/equations/automatic.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "formulations/constraints/constraints.h"

namespace desmo {

namespace automatic_equations {

template <class Kind>
using Operands = std::array<const double*, Kind::operand_sizes.size()>;

template <std::size_t N>
std::array<const double*, N> pointers(const double* state, const std::array<int, N>& positions) {
  std::array<const double*, N> result;
  for (std::size_t k = 0; k < N; ++k) result[k] = state + positions[k];
  return result;
}

/// Writes the partial derivatives of one constraint to their positions in values.
template <class Kind, class Object, class Operands>
inline void write_jacobian(const Object& o, const Operands& x, double* values) {
  int i = 0;
  Kind::jacobian(x.data(), constants_at<Kind>(o.constants.data(), x.data()).data(),
                 [&](int, int, int, double value) { values[o.slots[i++]] = value; });
}

/// Copies the equations that belong to the part to their rows.
template <std::size_t N>
void pick(const std::array<int, N>& rows, const std::array<double, N>& all, double* to) {
  for (std::size_t r = 0; r < N; ++r)
    if (rows[r] >= 0) to[rows[r]] = all[r];
}

}  // namespace automatic_equations

template <class Kind>
struct AutomaticEquations::SameKind {
  struct Object {
    std::array<int, Kind::operand_sizes.size()> operands;  // positions in the state
    /// Those of a table are many.
    std::conditional_t<has_table<Kind>, std::vector<double>, std::array<double, Kind::constants>>
        constants;
    int row;  // first row in the part, when the part has all rows
    std::array<int, Kind::entries> slots;
    std::array<int, Kind::rows> rows;  // row in the part; -1: belongs to another part
  };
  std::vector<Object> whole;  // all equations belong to the part
  std::vector<Object> cut;    // some equations belong to the part
};

struct AutomaticEquations::AllKinds {
  template <class... Kinds>
  static std::tuple<SameKind<Kinds>...> of(std::tuple<Kinds...>);
  decltype(of(std::declval<ConstraintKinds>())) of_kinds;
};

struct AutomaticEquations::Loops {
  void (*constant_jacobian)(const AllKinds&, double* values);
  void (*residual)(const AllKinds&, const double* state, double* phi);
  void (*jacobian)(const AllKinds&, const double* state, double* values);
  void (*quadratic)(const AllKinds&, const double* state, const double* rate, double* gamma);
};

template <class Kind, bool Whole>
struct AutomaticEquations::LoopsOf {
  static const auto& objects(const AllKinds& all_kinds) {
    const SameKind<Kind>& same_kind = std::get<SameKind<Kind>>(all_kinds.of_kinds);
    return Whole ? same_kind.whole : same_kind.cut;
  }

  static void constant_jacobian(const AllKinds& all_kinds, double* values) {
    if constexpr (Kind::linear)
      for (const auto& o : objects(all_kinds))
        automatic_equations::write_jacobian<Kind>(o, automatic_equations::Operands<Kind>{},
                                                  values);  // they read no state
  }

  static void residual(const AllKinds& all_kinds, const double* state, double* phi) {
    for (const auto& o : objects(all_kinds)) {
      const auto x = automatic_equations::pointers(state, o.operands);
      if constexpr (Whole) {
        Kind::residual(x.data(), constants_at<Kind>(o.constants.data(), x.data()).data(),
                       phi + o.row);
      } else {
        std::array<double, Kind::rows> all;
        Kind::residual(x.data(), constants_at<Kind>(o.constants.data(), x.data()).data(),
                       all.data());
        automatic_equations::pick(o.rows, all, phi);
      }
    }
  }

  static void jacobian(const AllKinds& all_kinds, const double* state, double* values) {
    if constexpr (!Kind::linear)
      for (const auto& o : objects(all_kinds))
        automatic_equations::write_jacobian<Kind>(
            o, automatic_equations::pointers(state, o.operands), values);
  }

  static void quadratic(const AllKinds& all_kinds, const double* state, const double* rate,
                        double* gamma) {
    for (const auto& o : objects(all_kinds)) {
      const auto x = automatic_equations::pointers(state, o.operands);
      const auto v = automatic_equations::pointers(rate, o.operands);
      if constexpr (Whole) {
        Kind::quadratic(x.data(), v.data(), constants_at<Kind>(o.constants.data(), x.data()).data(),
                        gamma + o.row);
      } else {
        std::array<double, Kind::rows> all;
        Kind::quadratic(x.data(), v.data(), constants_at<Kind>(o.constants.data(), x.data()).data(),
                        all.data());
        automatic_equations::pick(o.rows, all, gamma);
      }
    }
  }

  static constexpr Loops table{&constant_jacobian, &residual, &jacobian, &quadratic};
};

AutomaticEquations::AutomaticEquations(const Model& m, const PartDefinition& part)
    : all_kinds_(std::make_unique<AllKinds>()) {
  std::vector<JacobianEntry> entries;
  const int n = static_cast<int>(part.equations.size());
  for (int row = 0; row < n;) {
    const int position = part.equations[row].constraint;
    const Constraint& constraint = m.constraints[position];
    visit_kind(constraint.kind, [&]<class Kind>(Kind) {
      typename SameKind<Kind>::Object o;
      for (std::size_t k = 0; k < o.operands.size(); ++k)
        o.operands[k] = m.state_index(constraint.operands[k]);
      if constexpr (has_table<Kind>) o.constants.resize(constraint.constants.size());
      std::ranges::copy(constraint.constants, o.constants.begin());
      o.row = row;
      o.rows.fill(-1);
      for (; row < n && part.equations[row].constraint == position; ++row)
        o.rows[part.equations[row].row] = row;

      int i = 0;
      // The pattern is that of all values.
      static constexpr std::array<double, max_components> any{1, 1, 1, 1};
      automatic_equations::Operands<Kind> x;
      x.fill(any.data());
      Kind::jacobian(x.data(), constants_at<Kind>(o.constants.data(), x.data()).data(),
                     [&](int r, int operand, int component, double) {
                       o.slots[i++] =
                           static_cast<int>(entries.size());  // its place in `entries`, for now
                       entries.push_back({o.rows[r], o.operands[operand] + component,
                                          m.is_at_rest(constraint.operands[operand])});
                     });
      SameKind<Kind>& same_kind = std::get<SameKind<Kind>>(all_kinds_->of_kinds);
      (row - o.row == Kind::rows ? same_kind.whole : same_kind.cut).push_back(o);
    });
  }

  PatternWithSlots made = make_pattern(m, part, entries);
  pattern_ = std::move(made.pattern);
  const auto assign = [&]<class Kind>(SameKind<Kind>& same_kind) {
    for (auto* objects : {&same_kind.whole, &same_kind.cut})
      for (auto& o : *objects)
        for (int& slot : o.slots) slot = made.slots[slot];
    if (!same_kind.whole.empty()) loops_.push_back(&LoopsOf<Kind, true>::table);
    if (!same_kind.cut.empty()) loops_.push_back(&LoopsOf<Kind, false>::table);
  };
  std::apply([&](auto&... same_kind) { (assign(same_kind), ...); }, all_kinds_->of_kinds);
}

AutomaticEquations::~AutomaticEquations() = default;

void AutomaticEquations::constant_jacobian(double* values) const {
  for (const Loops* l : loops_) l->constant_jacobian(*all_kinds_, values);
}

void AutomaticEquations::residual(const double* state, double* phi) const {
  for (const Loops* l : loops_) l->residual(*all_kinds_, state, phi);
}

void AutomaticEquations::jacobian(const double* state, double* values) const {
  for (const Loops* l : loops_) l->jacobian(*all_kinds_, state, values);
}

void AutomaticEquations::quadratic(const double* state, const double* rate, double* gamma) const {
  for (const Loops* l : loops_) l->quadratic(*all_kinds_, state, rate, gamma);
}

}  // namespace desmo
