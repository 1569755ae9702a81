#include "formulations/verification/certificate/block_equations.h"

#include <algorithm>
#include <utility>

#include "formulations/constraints/constraints.h"
#include "formulations/constraints/jet.h"
#include "formulations/verification/certificate/table_enclosure.h"

namespace desmo {

namespace {

/// Scalar that finds the degree of a homogeneous polynomial; all other functions are `mixed`.
struct Degree {
  static constexpr int mixed = 99;
  int value = 0;

  Degree() = default;
  Degree(double) {}
  static Degree of(int degree) {
    Degree made;
    made.value = degree;
    return made;
  }

  friend Degree operator-(const Degree& a) { return a; }
  friend Degree operator+(const Degree& a, const Degree& b) {
    return of(a.value == b.value ? a.value : mixed);
  }
  friend Degree operator-(const Degree& a, const Degree& b) { return a + b; }
  friend Degree operator*(const Degree& a, const Degree& b) { return of(a.value + b.value); }
  friend Degree sin(const Degree&) { return of(mixed); }
  friend Degree cos(const Degree&) { return of(mixed); }
};

}  // namespace

struct BlockEquations::Functions {
  void (*motion)(const Object&, const States&, Level, const PerLevel<LaneInterval*>& phi);
  void (*jacobian)(const Object&, const std::vector<int>& slots, const LaneInterval* q,
                   LaneMatrix& to);
  void (*jacobian_rates)(const Object&, const States&, Level, PerLevel<LaneMatrix>& to);
};

template <class Kind>
struct BlockEquations::FunctionsOf {
  static constexpr std::size_t operands = Kind::operand_sizes.size();
  template <class S>
  using Constants = std::array<S, Kind::constants + 1>;

  /// Sets a scalar to a dimension.
  static void assign(Compensated<LaneNumbers>& to, const Object& o, int k) { to = o.constants[k]; }
  static void assign(LaneInterval& to, const Object& o, int k) { to = o.enclosed_constants[k]; }
  template <class S>
  static void assign(Jet<S>& to, const Object& o, int k) {
    assign(to.value, o, k);
  }

  /// Sets the constants of a kind. Those of a table are taken about the operands x.
  template <class S>
  static void set_constants(Constants<S>& c, const Object& o, const S* const* x) {
    if constexpr (has_table<Kind>) {
      for (int k = 0; k < Kind::table; ++k) assign(c[k], o, k);
      read_table<Kind>(c, x, [&](int lane, int k) {
        const Compensated<LaneNumbers>& n = o.constants[Kind::table + k];
        return Derived(n.value[lane], {n.correction[lane], n.radius[lane]});
      });
    } else {
      for (int k = 0; k < Kind::constants; ++k) assign(c[k], o, k);
    }
  }
  template <class S>
  static void set_constants(Constants<Jet<S>>& c, const Object& o, const Jet<S>* const* x) {
    if constexpr (has_table<Kind>) {
      const std::array<S, operands> values{x[0]->value, x[1]->value};
      const std::array<const S*, operands> at{&values[0], &values[1]};
      Constants<S> still;
      set_constants(still, o, at.data());
      for (int k = 0; k < Kind::constants; ++k) c[k] = Jet<S>(still[k]);
    } else {
      for (int k = 0; k < Kind::constants; ++k) assign(c[k], o, k);
    }
  }

  /// Operands and constants in the scalar S. make(i) returns local state i in it.
  template <class S>
  struct Operands {
    std::array<std::array<S, max_components>, operands> components;
    std::array<const S*, operands> x;
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
    return {x.position[i].mid, o.remainders[i].correction, o.remainders[i].radius};
  }

  static void write_rows(const Object& o, const Compensated<LaneNumbers>* all, LaneInterval* phi) {
    for (int r = 0; r < Kind::rows; ++r)
      if (o.shape->rows[r] >= 0) phi[o.shape->rows[r]] = all[r].enclosure();
  }
  static void motion(const Object& o, const States& x, Level level,
                     const PerLevel<LaneInterval*>& phi) {
    if (level == Level::position) {
      using S = Compensated<LaneNumbers>;
      const Operands<S> at(o, [&](int i) { return position(o, x, i); });
      std::array<S, Kind::rows> all;
      Kind::residual(at.x.data(), at.c.data(), all.data());
      write_rows(o, all.data(), phi.position);
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
  static void jacobian(const Object& o, const std::vector<int>& slots, const LaneInterval* q,
                       LaneMatrix& to) {
    std::array<const LaneInterval*, operands> x;
    for (std::size_t k = 0; k < operands; ++k) x[k] = q + o.shape->operands[k];
    Constants<LaneInterval> c;
    set_constants(c, o, x.data());
    const int* slot = slots.data();
    Kind::jacobian(x.data(), c.data(),
                   [&](int, int, int, const LaneInterval& value) { to.set(*slot++, value); });
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

  /// Returns the degree of each entry of the Jacobian.
  static std::vector<Degree> degrees() {
    std::array<Degree, max_components> any;
    any.fill(Degree::of(1));
    std::array<const Degree*, operands> x;
    x.fill(any.data());
    const Constants<Degree> c{};
    std::vector<Degree> all;
    Kind::jacobian(x.data(), c.data(), [&](int, int, int, const Degree& d) { all.push_back(d); });
    return all;
  }

  static constexpr Functions table{&motion, &jacobian, &jacobian_rates};
};

BlockEquations::BlockEquations(const std::vector<const ShapedBlock*>& lanes)
    : shape_(lanes.front()->shape),
      constants_(lanes.front()->constants.size() + 1),
      remainders_(shape_.states()) {
  for (int lane = 0; lane < LaneNumbers::count; ++lane) {
    const ShapedBlock& block = *lanes[lane];
    for (std::size_t k = 0; k < block.constants.size(); ++k)
      set_lane(constants_[k], lane, block.constants[k]);
    for (std::size_t i = 0; i < block.remainders.size(); ++i)
      set_lane(remainders_[i], lane, {0, block.remainders[i]});
    if (std::ranges::none_of(block.slack, [](double radius) { return radius > 0; })) continue;
    slack_.resize(shape_.unknowns);
    for (std::size_t row = 0; row < slack_.size(); ++row) slack_[row].set(lane, block.slack[row]);
  }
  for (const auto& c : constants_) enclosed_constants_.push_back(c.enclosure());
  for (const auto& r : remainders_) radii_.push_back(rest_of(r));
  for (const BlockShape::Object& o : shape_.objects) add(o);
  linear_ = LinearEquations(shape_, constants_, remainders_);
  std::vector<bool> varies(shape_.entries.size());
  for (const Object& o : objects_)
    for (const int slot : o.quadratic ? o.rate_slots : o.shape->slots)
      if (slot >= 0) varies[slot] = true;
  for (std::size_t e = 0; e < varies.size(); ++e)
    if (!varies[e]) constant_entries_.push_back(static_cast<int>(e));
}

void BlockEquations::add(const BlockShape::Object& o) {
  visit_kind(o.kind, [&]<class Kind>(Kind) {
    if constexpr (!Kind::linear) {
      const std::vector<Degree> degrees = FunctionsOf<Kind>::degrees();
      Object made{&FunctionsOf<Kind>::table,
                  &o,
                  &constants_[o.first_constant],
                  &enclosed_constants_[o.first_constant],
                  remainders_.data(),
                  true,
                  o.slots};
      for (std::size_t k = 0; k < degrees.size(); ++k) {
        made.quadratic &= degrees[k].value <= 1;
        if (degrees[k].value == 0) made.rate_slots[k] = -1;
      }
      objects_.push_back(std::move(made));
    }
  });
}

void BlockEquations::motion(const States& x, Level level,
                            const PerLevel<LaneInterval*>& phi) const {
  for (const Object& o : objects_) o.functions->motion(o, x, level, phi);
  linear_.motion(x, level, phi);
  for (std::size_t row = 0; row < slack_.size(); ++row)
    phi.position[row] = phi.position[row] + LaneInterval(0, slack_[row]);
}

void BlockEquations::jacobian(const LaneInterval* q, LaneMatrix& to) const {
  for (const Object& o : objects_) o.functions->jacobian(o, o.shape->slots, q, to);
}

void BlockEquations::jacobian_rates(const States& x, Level level, PerLevel<LaneMatrix>& to) const {
  for (const int e : constant_entries_) to[level].set(e, {});
  for (const Object& o : objects_) {
    if (!o.quadratic) {
      o.functions->jacobian_rates(o, x, level, to);
      continue;
    }
    // Entries are homogeneous of degree 1 in q, so their rates are the same functions of q̇ and q̈.
    o.functions->jacobian(o, o.rate_slots, x.velocity, to.velocity);
    if (level == Level::acceleration)
      o.functions->jacobian(o, o.rate_slots, x.acceleration, to.acceleration);
  }
}

}  // namespace desmo
