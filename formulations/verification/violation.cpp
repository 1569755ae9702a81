#include "formulations/verification/violation.h"

#include <algorithm>
#include <cmath>

#include "formulations/groupwise/jet.h"
#include "formulations/verification/reference/whole_system.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo {

struct ViolationMeasure::WideEquations {
  WholeSystem system;
  std::vector<Jet<Quadruple>> state, phi;
  std::vector<double> positions;  // of the state

  explicit WideEquations(const Model& m)
      : system(m), state(m.state_size()), phi(system.rows()), positions(m.state_size()) {
    for (std::size_t i = 0; i < m.fixed_values.size(); ++i) {
      positions[m.coordinates() + i] = m.fixed_values[i];
      state[m.coordinates() + i] = Jet<Quadruple>(m.fixed_values[i]);
    }
  }

  void set(const Instant& instant) {
    for (std::size_t i = 0; i < instant.q.size(); ++i) {
      positions[i] = instant.q[i];
      state[i] = {instant.q[i], instant.qd.empty() ? 0.0 : instant.qd[i],
                  instant.qdd.empty() ? 0.0 : instant.qdd[i]};
    }
  }
};

ViolationMeasure::ViolationMeasure(const Model& m, const Scales& scales,
                                   std::span<const double> times)
    : equations_(std::make_unique<WideEquations>(m)), times_(times) {
  for (const Level level : levels) {
    coordinate_scales_[level].assign(m.state_size(), 0);
    row_scales_[level].resize(equations_->system.rows());
    for (EntityId id = 0; id < static_cast<EntityId>(m.entities.size()); ++id)
      std::fill_n(coordinate_scales_[level].begin() + m.state_index(id), m.entities[id].size,
                  scales.of(m.entities[id].kind, level));
  }
}

ViolationMeasure::~ViolationMeasure() = default;

Flow ViolationMeasure::observe(const Instant& instant) noexcept {
  while (next_ < times_.size() && times_[next_] < instant.time) ++next_;
  if (next_ == times_.size() || times_[next_] != instant.time) return Flow::go_on;
  ++next_;
  ++instants_;
  WideEquations& e = *equations_;
  e.set(instant);
  e.system.residual<Jet<Quadruple>>(e.state, e.phi);
  for (const Level level : levels) std::ranges::fill(row_scales_[level], 0.0);
  e.system.jacobian<double>(e.positions, [&](int row, int state, double value) {
    for (const Level level : levels)
      row_scales_[level][row] += std::abs(value) * coordinate_scales_[level][state];
  });

  const auto add = [&](Level level, Quadruple Jet<Quadruple>::*order) {
    for (std::size_t row = 0; row < e.phi.size(); ++row)
      sums_[level].add(relative(static_cast<double>(e.phi[row].*order), row_scales_[level][row]));
  };
  add(Level::position, &Jet<Quadruple>::value);
  if (!instant.qd.empty()) add(Level::velocity, &Jet<Quadruple>::first);
  if (!instant.qdd.empty()) add(Level::acceleration, &Jet<Quadruple>::second);
  return Flow::go_on;
}

SolutionError ViolationMeasure::violation() const {
  SolutionError result;
  for (const Level level : levels) result[level] = sums_[level].result();
  result.instants = instants_;
  return result;
}

}  // namespace desmo
