#include "formulations/verification/certificate/block_equations.h"

#include <algorithm>
#include <utility>

#include "formulations/verification/certificate/block_functions.h"

namespace desmo {

namespace {

/// Scalar that finds the degree of a homogeneous polynomial. All other functions have a degree of
/// `mixed` or more.
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

/// Returns the degree of each entry of a kind's Jacobian, in their order.
template <class Kind>
std::vector<Degree> entry_degrees() {
  std::array<Degree, max_components> any;
  any.fill(Degree::of(1));
  std::array<const Degree*, Kind::operand_sizes.size()> x;
  x.fill(any.data());
  const std::array<Degree, Kind::constants + 1> c{};
  std::vector<Degree> all;
  Kind::jacobian(x.data(), c.data(), [&](int, int, int, const Degree& d) { all.push_back(d); });
  return all;
}

}  // namespace

BlockEquations::BlockEquations(const std::vector<const ShapedBlock*>& lanes)
    : shape_(lanes.front()->shape),
      constants_(lanes.front()->constants.size() + 1),
      fixed_(shape_.states()) {
  for (int lane = 0; lane < LaneNumbers::count; ++lane) {
    const ShapedBlock& block = *lanes[lane];
    for (std::size_t k = 0; k < block.constants.size(); ++k)
      set_lane(constants_[k], lane, block.constants[k]);
    for (std::size_t i = 0; i < block.fixed.size(); ++i) set_lane(fixed_[i], lane, block.fixed[i]);
    if (std::ranges::none_of(block.slack, [](double radius) { return radius > 0; })) continue;
    slack_.resize(shape_.unknowns);
    for (std::size_t row = 0; row < slack_.size(); ++row) slack_[row].set(lane, block.slack[row]);
  }
  enclosed_constants_.reserve(constants_.size());
  path_constants_.reserve(constants_.size());
  for (const auto& c : constants_) {
    enclosed_constants_.push_back(c.enclosure());
    path_constants_.emplace_back(c.value, 0, rest_of(c));
  }
  for (const auto& x : fixed_) radii_.push_back(rest_of(x));
  for (int i = 0; i < shape_.states(); ++i)  // a block of linear equations reads no others
    if (shape_.columns[i] < 0 && !(shape_.linear && shape_.columns[i] == BlockShape::unread))
      written_.push_back(i);
  for (const BlockShape::Object& o : shape_.objects) add(o);
  linear_ = LinearEquations(shape_, constants_, fixed_);
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
      const std::vector<Degree> degrees = entry_degrees<Kind>();
      Object made{FunctionsOf<Kind>::at_instants,
                  path_functions(o.kind),
                  &o,
                  &constants_[o.first_constant],
                  &enclosed_constants_[o.first_constant],
                  &path_constants_[o.first_constant],
                  fixed_.data(),
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

void BlockEquations::motion(const States& x, Level level, States& phi) const {
  for (const Object& o : objects_) o.functions.motion(o, x, level, phi);
  linear_.motion(x, level, phi);
  for (std::size_t row = 0; row < slack_.size(); ++row)
    phi.position[row] = phi.position[row] + LaneInterval(0, slack_[row]);
}

void BlockEquations::jacobian(const LaneInterval* q, LaneMatrix& to) const {
  for (const Object& o : objects_) o.functions.jacobian(o, o.shape->slots, q, to);
}

void BlockEquations::jacobian_rates(const States& x, Level level, PerLevel<LaneMatrix>& to) const {
  for (const int e : constant_entries_) to[level].set(e, LaneInterval());
  for (const Object& o : objects_) {
    if (!o.quadratic) {
      o.functions.jacobian_rates(o, x, level, to);
      continue;
    }
    // Entries are homogeneous of degree 1 in q, so their rates are the same functions of q̇ and q̈.
    o.functions.jacobian(o, o.rate_slots, x.velocity.data(), to.velocity);
    if (level == Level::acceleration)
      o.functions.jacobian(o, o.rate_slots, x.acceleration.data(), to.acceleration);
  }
}

}  // namespace desmo
