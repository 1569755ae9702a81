#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include "formulations/constraints/constraints.h"
#include "formulations/constraints/jet.h"
#include "formulations/verification/certificate/block_equations.h"
#include "formulations/verification/certificate/table_enclosure.h"

namespace desmo {

static_assert(EquationScalar<Jet<Compensated<LaneNumbers>>> && EquationScalar<Jet<LaneInterval>> &&
              EquationScalar<LaneInterval> && EquationScalar<PathValue> &&
              EquationScalar<PathSlope>);

/// The functions of a kind in the scalars of proofs.
template <class Kind>
struct BlockEquations::FunctionsOf {
  static constexpr std::size_t operands = Kind::operand_sizes.size();
  template <class S>
  using Constants = std::array<S, Kind::constants + 1>;
  template <class S>
  using Pointers = std::array<const S*, operands>;

  template <class S>
  static Pointers<S> operands_in(const Object& o, const S* states) {
    Pointers<S> x;
    for (std::size_t k = 0; k < operands; ++k) x[k] = states + o.shape->operands[k];
    return x;
  }

  /// Sets a scalar to constant k.
  static void assign(Compensated<LaneNumbers>& to, const Object& o, int k) { to = o.constants[k]; }
  static void assign(LaneInterval& to, const Object& o, int k) { to = o.enclosed_constants[k]; }
  template <class S>
  static void assign(Jet<S>& to, const Object& o, int k) {
    assign(to.value, o, k);
  }
  template <int D>
  static void assign(TaylorModel<LaneNumbers, D>& to, const Object& o, int k) {
    to.c[0] = o.path_constants[k].value;
    to.rest = o.path_constants[k].radius;
  }
  /// Sets the constants of a kind at operands x.
  template <class S>
  static void set_constants(Constants<S>& c, const Object& o, const S* const* x) {
    constexpr bool is_path = std::is_same_v<S, PathValue> || std::is_same_v<S, PathSlope>;
    for (int k = 0; k < (has_table<Kind> ? int{TableCoupling::table} : int{Kind::constants}); ++k)
      assign(c[k], o, k);
    if constexpr (has_table<Kind>)
      set_table_constants(c.data(), x, [&](int lane, int k) {
        const Compensated<LaneNumbers>& n = (is_path ? o.path_constants : o.constants)[k];
        return Derived(n.value[lane], {n.correction[lane], n.radius[lane]});
      });
  }

  /// Operands and constants in the scalar S. make(i) returns local state i in it.
  template <class S>
  struct Operands {
    std::array<std::array<S, max_components>, operands> components;
    Pointers<S> x;
    Constants<S> c;

    template <class Make>
    Operands(const Object& o, Make&& make) {
      for (std::size_t k = 0; k < operands; ++k) {
        for (int i = 0; i < Kind::operand_sizes[k]; ++i)
          components[k][i] = make(o.shape->operands[k] + i);
        x[k] = components[k].data();
      }
      set_constants(c, o, x.data());
    }
  };
  static Compensated<LaneNumbers> exact(const LaneNumbers& x) { return {x, 0, 0}; }
  static Compensated<LaneNumbers> position(const Object& o, const States& x, int i) {
    return {x.position[i].mid, o.fixed[i].correction, o.fixed[i].radius};
  }

  static void motion(const Object& o, const States& x, Level level, States& phi) {
    if (level == Level::position) {
      using S = Compensated<LaneNumbers>;
      const Operands<S> at(o, [&](int i) { return position(o, x, i); });
      std::array<S, Kind::rows> all;
      Kind::residual(at.x.data(), at.c.data(), all.data());
      for (int r = 0; r < Kind::rows; ++r)
        if (o.shape->rows[r] >= 0) phi.position[o.shape->rows[r]] = all[r].enclosure();
      return;
    }
    using S = Jet<Compensated<LaneNumbers>>;
    const Operands<S> at(o, [&](int i) {
      return S(position(o, x, i), exact(x.velocity[i].mid),
               level == Level::acceleration ? exact(x.acceleration[i].mid) : exact(0));
    });
    std::array<S, Kind::rows> all;
    Kind::residual(at.x.data(), at.c.data(), all.data());
    for (int r = 0; r < Kind::rows; ++r) {
      const int row = o.shape->rows[r];
      if (row < 0) continue;
      phi.position[row] = all[r].value.enclosure();
      phi.velocity[row] = all[r].first.enclosure();
      if (level == Level::acceleration) phi.acceleration[row] = all[r].second.enclosure();
    }
  }
  static void residual(const Object& o, const PathValue* states, PathValue* phi) {
    const Pointers<PathValue> x = operands_in(o, states);
    Constants<PathValue> c;
    set_constants(c, o, x.data());
    std::array<PathValue, Kind::rows> all;
    Kind::residual(x.data(), c.data(), all.data());
    for (int r = 0; r < Kind::rows; ++r)
      if (o.shape->rows[r] >= 0) phi[o.shape->rows[r]] = all[r];
  }
  template <class S>
  static void jacobian(const Object& o, const std::vector<int>& slots, const S* states,
                       LaneMatrix& to) {
    const Pointers<S> x = operands_in(o, states);
    Constants<S> c;
    set_constants(c, o, x.data());
    const int* slot = slots.data();
    Kind::jacobian(x.data(), c.data(),
                   [&](int, int, int, const S& value) { to.set(*slot++, value); });
  }
  static void jacobian_rates(const Object& o, const States& x, Level level,
                             PerLevel<LaneMatrix>& to) {
    using S = Jet<LaneInterval>;
    const Operands<S> at(o, [&](int i) {
      return S(x.position[i], x.velocity[i],
               level == Level::acceleration ? x.acceleration[i] : LaneInterval());
    });
    const int* slot = o.shape->slots.data();
    Kind::jacobian(at.x.data(), at.c.data(), [&](int, int, int, const S& value) {
      to.velocity.set(*slot, value.first);
      if (level == Level::acceleration) to.acceleration.set(*slot, value.second);
      ++slot;
    });
  }

  static constexpr Functions at_instants{&motion, &jacobian<LaneInterval>, &jacobian_rates};
  static constexpr PathFunctions along_paths{&residual, &jacobian<PathSlope>};
};

}  // namespace desmo
