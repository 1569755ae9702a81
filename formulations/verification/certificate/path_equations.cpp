#include "formulations/verification/certificate/path_equations.h"

#include <array>

#include "formulations/constraints/constraints.h"
#include "formulations/verification/certificate/table_enclosure.h"

namespace desmo {

template <class Kind>
struct PathEquations::FunctionsOf {
  /// Operands and constants of a constraint in the scalar S.
  template <class S>
  struct Arguments {
    std::array<const S*, Kind::operand_sizes.size()> x;
    std::array<S, Kind::constants + 1> c;

    Arguments(const Object& o, const S* states) {
      for (std::size_t k = 0; k < x.size(); ++k) x[k] = states + o.shape->operands[k];
      constexpr int count = has_table<Kind> ? 3 : Kind::constants;
      for (int i = 0; i < count; ++i) {
        c[i].c[0] = o.constants[i].mid;
        c[i].rest = o.constants[i].radius;
      }
      if constexpr (has_table<Kind>)
        read_table<Kind>(c, x.data(), [&](int lane, int k) {
          const LaneInterval& number = o.constants[count + k];
          return Derived(number.mid[lane], {0, number.radius[lane]});
        });
    }
  };

  static void residual(const Object& o, const Value* states, Value* phi) {
    const Arguments<Value> at(o, states);
    std::array<Value, Kind::rows> all;
    Kind::residual(at.x.data(), at.c.data(), all.data());
    for (int r = 0; r < Kind::rows; ++r)
      if (o.shape->rows[r] >= 0) phi[o.shape->rows[r]] = all[r];
  }
  static void jacobian(const Object& o, const Slope* states, LaneMatrix& to) {
    const Arguments<Slope> at(o, states);
    const int* slot = o.shape->slots.data();
    Kind::jacobian(at.x.data(), at.c.data(), [&](int, int, int, const Slope& entry) {
      if (*slot >= 0) {
        to.mid[*slot] = entry.c[0];
        to.radius[*slot] = entry.variation();
      }
      ++slot;
    });
  }
};

PathEquations::PathEquations(const Model& m, const BlockBatch& batch)
    : linear_(batch.equations.linear()) {
  constants_.resize(batch.in_lane(0).block.constants.size() + 1);
  for (std::size_t k = 0; k + 1 < constants_.size(); ++k)
    for (int lane = 0; lane < LaneNumbers::count; ++lane)
      set_lane(constants_[k], lane, batch.in_lane(lane).block.constants[k]);
  const BlockShape& shape = batch.equations.shape();
  for (const BlockShape::Object& o : shape.objects) add(o);
  for (int i = 0; i < shape.states(); ++i) {
    // A block of linear equations never reads unread states.
    if (shape.columns[i] >= 0 || (shape.linear && shape.columns[i] == BlockShape::unread)) continue;
    FixedState made{i, {}};
    for (int lane = 0; lane < LaneNumbers::count && shape.columns[i] == BlockShape::fixed; ++lane) {
      const int at = batch.in_lane(lane).block.states[i] - m.coordinates();
      set_lane(made.value, lane, m.fixed_value(at));
    }
    fixed_.push_back(made);
  }
}

void PathEquations::write_fixed(Value* x) const {
  for (const FixedState& f : fixed_) {
    x[f.state] = {};
    x[f.state].c[0] = f.value.mid;
    x[f.state].rest = f.value.radius;
  }
}

void PathEquations::add(const BlockShape::Object& o) {
  visit_kind(o.kind, [&]<class Kind>(Kind) {
    if constexpr (!Kind::linear)
      objects_.push_back({&o, &constants_[o.first_constant], &FunctionsOf<Kind>::residual,
                          &FunctionsOf<Kind>::jacobian});
  });
}

void PathEquations::residual(const Value* x, Value* phi) const {
  for (const Object& o : objects_) o.residual(o, x, phi);
  for (const LinearEquations::Equation& e : linear_.equations()) {
    Value sum;
    sum.c[0] = e.at_origin.mid;
    sum.rest = e.at_origin.radius;
    for (const LinearEquations::Term& t : e.terms) sum.add_product(t.enclosed, x[t.state]);
    phi[e.row] = sum;
  }
}

void PathEquations::jacobian(const Slope* x, LaneMatrix& to) const {
  for (const Object& o : objects_) o.jacobian(o, x, to);
}

}  // namespace desmo
