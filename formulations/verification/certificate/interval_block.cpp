#include "formulations/verification/certificate/interval_block.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "formulations/constraints/constraints.h"
#include "formulations/groupwise/jet.h"

namespace desmo {

using States = PerLevel<const Interval*>;

struct IntervalBlock::Functions {
  void (*residual)(const Object&, const Interval* q, Interval* phi);
  void (*jacobian)(const Object&, const Interval* q, IntervalMatrix& to);
  void (*motion)(const Object&, const States&, Level, const PerLevel<Interval*>& phi);
  void (*jacobian_rates)(const Object&, const States&, Level, PerLevel<IntervalMatrix>& to);
};

namespace {

/// Operands of a kind in jets, that is, with their rates up to a level.
template <class Kind>
struct Motions {
  static constexpr std::size_t operands = Kind::operand_sizes.size();
  using Motion = Jet<Interval>;

  Motions(const std::array<int, 5>& first, const Interval* c, const States& state, Level level) {
    for (std::size_t k = 0; k < operands; ++k) {
      for (int i = 0; i < Kind::operand_sizes[k]; ++i) {
        const int at = first[k] + i;
        components[k][i].value = state.position[at];
        components[k][i].first = state.velocity[at];
        if (level == Level::acceleration) components[k][i].second = state.acceleration[at];
      }
      x[k] = components[k].data();
    }
    std::copy_n(c, Kind::constants, constants.begin());
  }

  std::array<std::array<Motion, 3>, operands> components;
  std::array<const Motion*, operands> x;
  std::array<Motion, Kind::constants + 1> constants;
};

}  // namespace

template <class Kind>
struct IntervalBlock::FunctionsOf {
  static constexpr std::size_t operands = Kind::operand_sizes.size();
  static_assert(operands <= max_operands && Kind::rows <= max_rows);

  static std::array<const Interval*, operands> at(const Object& o, const Interval* state) {
    std::array<const Interval*, operands> x;
    for (std::size_t k = 0; k < operands; ++k) x[k] = state + o.operands[k];
    return x;
  }
  static void write(const Interval& value, int slot, IntervalMatrix& to) {
    if (slot < 0) return;
    to.mid[slot] = value.mid;
    to.radius[slot] = value.radius;
  }

  static void residual(const Object& o, const Interval* q, Interval* phi) {
    std::array<Interval, Kind::rows> all;
    Kind::residual(at(o, q).data(), o.constants, all.data());
    for (int r = 0; r < Kind::rows; ++r)
      if (o.rows[r] >= 0) phi[o.rows[r]] = all[r];
  }
  static void jacobian(const Object& o, const Interval* q, IntervalMatrix& to) {
    const int* slot = o.slots.data();
    Kind::jacobian(at(o, q).data(), o.constants,
                   [&](int, int, int, const Interval& value) { write(value, *slot++, to); });
  }
  static void motion(const Object& o, const States& state, Level level,
                     const PerLevel<Interval*>& phi) {
    if constexpr (Kind::linear) {  // and homogeneous
      residual(o, state.position, phi.position);
      residual(o, state.velocity, phi.velocity);
      if (level == Level::acceleration) residual(o, state.acceleration, phi.acceleration);
    } else {
      const Motions<Kind> operands(o.operands, o.constants, state, level);
      std::array<Jet<Interval>, Kind::rows> all;
      Kind::residual(operands.x.data(), operands.constants.data(), all.data());
      for (int r = 0; r < Kind::rows; ++r) {
        if (o.rows[r] < 0) continue;
        phi.position[o.rows[r]] = all[r].value;
        phi.velocity[o.rows[r]] = all[r].first;
        if (level == Level::acceleration) phi.acceleration[o.rows[r]] = all[r].second;
      }
    }
  }
  static void jacobian_rates(const Object& o, const States& state, Level level,
                             PerLevel<IntervalMatrix>& to) {
    if constexpr (!Kind::linear) {
      const Motions<Kind> operands(o.operands, o.constants, state, level);
      const int* slot = o.slots.data();
      Kind::jacobian(operands.x.data(), operands.constants.data(),
                     [&](int, int, int, const Jet<Interval>& value) {
                       write(value.first, *slot, to.velocity);
                       if (level == Level::acceleration)
                         write(value.second, *slot, to.acceleration);
                       ++slot;
                     });
    }
  }

  static constexpr Functions table{&residual, &jacobian, &motion, &jacobian_rates};
};

namespace {

/// Returns the states that equations of a block depend on, in ascending order. Another component of
/// an operand may belong to another row of the constraint, and be solved later.
std::vector<int> states_of(const Model& m, const PartDefinition& block) {
  std::vector<int> states;
  const std::vector<Interval> any(3);  // the entries are those of all values
  for (const Equation& equation : block.equations) {
    const Constraint& c = m.constraints[equation.constraint];
    std::vector<Interval> constants(c.constants.begin(), c.constants.end());
    constants.emplace_back();  // never read; data() is not null
    visit_kind(c.kind, [&]<class Kind>(Kind) {
      std::array<const Interval*, Kind::operand_sizes.size()> x;
      x.fill(any.data());
      Kind::jacobian(x.data(), constants.data(), [&](int r, int operand, int i, const Interval&) {
        if (r == equation.row) states.push_back(m.state_index(c.operands[operand]) + i);
      });
    });
  }
  std::ranges::sort(states);
  states.erase(std::ranges::unique(states).begin(), states.end());
  return states;
}

}  // namespace

IntervalBlock::IntervalBlock(const Model& m, const PartDefinition& block)
    : unknowns_(block.unknowns) {
  std::ranges::set_difference(states_of(m, block), unknowns_, std::back_inserter(inputs_));
  std::erase_if(inputs_, [&](int i) { return i >= m.coordinates(); });  // fixed ones are exact
  const int n = static_cast<int>(block.equations.size());
  for (int row = 0; row < n; ++row)
    if (row == 0 || block.equations[row].constraint != block.equations[row - 1].constraint)
      add(m, m.constraints[block.equations[row].constraint], block,
          block.equations[row].constraint);
}

void IntervalBlock::add(const Model& m, const Constraint& constraint, const PartDefinition& block,
                        int position) {
  visit_kind(constraint.kind, [&]<class Kind>(Kind) {
    Object o{&FunctionsOf<Kind>::table, {}, {}, nullptr, {}};
    for (std::size_t k = 0; k < constraint.operands.size(); ++k)
      o.operands[k] = m.state_index(constraint.operands[k]);
    o.rows.fill(-1);
    for (int row = 0; row < size(); ++row)
      if (block.equations[row].constraint == position) o.rows[block.equations[row].row] = row;
    std::vector<Interval>& c =
        constants_.emplace_back(constraint.constants.begin(), constraint.constants.end());
    c.emplace_back();  // never read; data() is not null
    o.constants = c.data();

    const auto find = [](const std::vector<int>& in, int state) {
      const auto it = std::ranges::lower_bound(in, state);
      return it != in.end() && *it == state ? static_cast<int>(it - in.begin()) : -1;
    };
    const std::vector<Interval> any(3);  // the entries are those of all values
    std::array<const Interval*, Kind::operand_sizes.size()> x;
    x.fill(any.data());
    Kind::jacobian(x.data(), o.constants, [&](int r, int operand, int i, const Interval&) {
      const int state = o.operands[operand] + i;
      const int unknown = find(unknowns_, state), input = find(inputs_, state);
      const int column = unknown >= 0 ? unknown : input >= 0 ? size() + input : -1;
      o.slots.push_back(o.rows[r] < 0 || column < 0 ? -1 : o.rows[r] * stride() + column);
    });
    linear_ = linear_ && Kind::linear;
    objects_.push_back(std::move(o));
  });
}

IntervalMatrix IntervalBlock::make_matrix() const {
  const std::size_t entries = unknowns_.size() * static_cast<std::size_t>(stride());
  return {std::vector<double>(entries), std::vector<double>(entries)};
}

void IntervalBlock::residual(const Interval* q, Interval* phi) const {
  for (const Object& o : objects_) o.functions->residual(o, q, phi);
}
void IntervalBlock::jacobian(const Interval* q, IntervalMatrix& to) const {
  for (const Object& o : objects_) o.functions->jacobian(o, q, to);
}
void IntervalBlock::motion(const States& state, Level level, const PerLevel<Interval*>& phi) const {
  for (const Object& o : objects_) o.functions->motion(o, state, level, phi);
}
void IntervalBlock::jacobian_rates(const States& state, Level level,
                                   PerLevel<IntervalMatrix>& to) const {
  for (const Object& o : objects_) o.functions->jacobian_rates(o, state, level, to);
}

}  // namespace desmo
