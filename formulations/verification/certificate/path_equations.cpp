#include "formulations/verification/certificate/path_equations.h"

#include <array>
#include <utility>

#include "formulations/constraints/constraints.h"
#include "formulations/verification/certificate/table_enclosure.h"

namespace desmo {

template <class Kind>
struct PathEquations::FunctionsOf {
  /// Operands and constants of a constraint in a scalar.
  template <class S>
  struct Arguments {
    std::array<const S*, Kind::operand_sizes.size()> x;
    std::array<S, Kind::constants + 1> c;

    Arguments(const Object& o, const S* states) {
      for (std::size_t k = 0; k < x.size(); ++k) x[k] = states + o.shape->operands[k];
      constexpr int count = has_table<Kind> ? 3 : Kind::constants;
      for (int i = 0; i < count; ++i) {
        c[i].c[0] = o.constants[i];
        c[i].rest = o.remainders[i];
      }
      if constexpr (has_table<Kind>)
        read_table<Kind>(c, x.data(), [&](int lane, int k) {
          return Derived(o.constants[count + k][lane], {0, o.remainders[count + k][lane]});
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

PathEquations::PathEquations(const Model& m, const BlockBatch& batch) {
  constants_.resize(batch.in_lane(0).block.constants.size() + 1);
  remainders_.resize(constants_.size());
  for (std::size_t k = 0; k + 1 < constants_.size(); ++k)
    for (int lane = 0; lane < LaneNumbers::count; ++lane) {
      const TaylorModel<double, 1> constant(batch.in_lane(lane).block.constants[k]);
      constants_[k].set(lane, constant.c[0]);
      remainders_[k].set(lane, constant.rest);
    }
  const BlockShape& shape = batch.equations.shape();
  for (const BlockShape::Object& o : shape.objects) add(o);
  for (int i = 0; i < shape.states(); ++i) {
    // Linear equations read no others.
    if (shape.columns[i] >= 0 || (shape.linear && shape.columns[i] == BlockShape::unread)) continue;
    FixedState made{i, 0, 0};
    for (int lane = 0; lane < LaneNumbers::count && shape.columns[i] == BlockShape::fixed; ++lane) {
      const int at = batch.in_lane(lane).block.states[i] - m.coordinates();
      const TaylorModel<double, 1> number(m.fixed_value(at));
      made.value.set(lane, number.c[0]);
      made.rest.set(lane, number.rest);
    }
    fixed_.push_back(made);
  }
}

void PathEquations::write_fixed(Value* x) const {
  for (const FixedState& f : fixed_) {
    x[f.state] = {};
    x[f.state].c[0] = f.value;
    x[f.state].rest = f.rest;
  }
}

void PathEquations::add(const BlockShape::Object& o) {
  visit_kind(o.kind, [&]<class Kind>(Kind) {
    const Object made{&o, &constants_[o.first_constant], &remainders_[o.first_constant],
                      &FunctionsOf<Kind>::residual, &FunctionsOf<Kind>::jacobian};
    if constexpr (!Kind::linear) {
      objects_.push_back(made);
    } else {
      // Φ = Φ_q q + Φ(0)
      const std::array<Slope, max_components> zero{};
      typename FunctionsOf<Kind>::template Arguments<Slope> at(made, zero.data());
      at.x.fill(zero.data());
      std::array<Slope, Kind::rows> at_origin;
      Kind::residual(at.x.data(), at.c.data(), at_origin.data());
      std::array<LinearRow, Kind::rows> rows;
      for (int r = 0; r < Kind::rows; ++r) rows[r] = {o.rows[r], at_origin[r], {}};
      Kind::jacobian(at.x.data(), at.c.data(), [&](int r, int operand, int i, const Slope& factor) {
        rows[r].terms.push_back({o.operands[operand] + i, factor});
      });
      for (LinearRow& row : rows)
        if (row.row >= 0) linear_rows_.push_back(std::move(row));
    }
  });
}

void PathEquations::residual(const Value* x, Value* phi) const {
  for (const Object& o : objects_) o.residual(o, x, phi);
  for (const LinearRow& r : linear_rows_) {
    Value sum;
    sum.c[0] = r.at_origin.c[0];
    sum.rest = r.at_origin.rest;
    for (const LinearRow::Term& t : r.terms) sum.add_product(t.factor, x[t.state]);
    phi[r.row] = sum;
  }
}

void PathEquations::jacobian(const Slope* x, LaneMatrix& to) const {
  for (const Object& o : objects_) o.jacobian(o, x, to);
}

}  // namespace desmo
