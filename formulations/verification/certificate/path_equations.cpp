#include "formulations/verification/certificate/path_equations.h"

#include <array>

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

PathEquations::PathEquations(const BlockBatch& batch) {
  constants_.resize(batch.in_lane(0).block.constants.size() + 1);
  remainders_.resize(constants_.size());
  for (std::size_t k = 0; k + 1 < constants_.size(); ++k)
    for (int lane = 0; lane < LaneNumbers::count; ++lane) {
      const TaylorModel<double, 1> constant(batch.in_lane(lane).block.constants[k]);
      constants_[k].set(lane, constant.c[0]);
      remainders_[k].set(lane, constant.rest);
    }
  for (const BlockShape::Object& o : batch.equations.shape().objects)
    visit_kind(o.kind, [&]<class Kind>(Kind) {
      objects_.push_back({&o, constants_.data() + o.first_constant,
                          remainders_.data() + o.first_constant, &FunctionsOf<Kind>::residual,
                          Kind::linear ? nullptr : &FunctionsOf<Kind>::jacobian});
    });
}

void PathEquations::residual(const Value* x, Value* phi) const {
  for (const Object& o : objects_) o.residual(o, x, phi);
}

void PathEquations::jacobian(const Slope* x, LaneMatrix& to) const {
  for (const Object& o : objects_)
    if (o.jacobian) o.jacobian(o, x, to);
}

}  // namespace desmo
