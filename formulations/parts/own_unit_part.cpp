#include "formulations/parts/own_unit_part.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "formulations/scaling/scales.h"
#include "formulations/structure/part_type.h"

namespace desmo {

namespace {

/// Binary orders up to which products of fifteen lengths do not overflow.
constexpr int far = 64;

/// The constraints of a part, each once.
std::vector<int> constraints_of(const PartDefinition& part) {
  std::vector<int> all;
  for (const Equation& e : part.equations)
    if (all.empty() || all.back() != e.constraint) all.push_back(e.constraint);
  return all;
}

/// The longest of the part's unknowns that are lengths; 0: none is. They are found among what its
/// equations read: to look through the whole mechanism for each part would take its square.
double max_length(const Model& m, const PartDefinition& part, std::span<const double> magnitudes) {
  double longest = 0;
  for (const int c : constraints_of(part))
    for (const EntityId id : m.constraints[c].operands) {
      const Entity& e = m.entities[id];
      if (e.fixed || !is_length(e.kind)) continue;
      const auto found = std::ranges::lower_bound(part.unknowns, e.first);
      if (found == part.unknowns.end() || *found >= e.first + e.size) continue;
      longest = std::max(longest, magnitudes[found - part.unknowns.begin()]);
    }
  return longest;
}

}  // namespace

/// The part that is fallen back to, called with its own state.
class OwnUnitPart::InUnitOfAll final : public Part {
 public:
  InUnitOfAll(OwnUnitPart& part, std::unique_ptr<Part> solver)
      : part_(part), solver_(std::move(solver)) {}

  PartResult solve(State&, std::span<const double>, Level level) override {
    for (const int i : part_.unknowns_) {
      const int of_all = part_.inputs_[i];
      part_.all_->q[of_all] = part_.last_[of_all];
    }
    const PartResult result = solver_->solve(*part_.all_, part_.last_, level);
    part_.take(*part_.all_);
    return result;
  }
  void forget() override { solver_->forget(); }

 private:
  OwnUnitPart& part_;
  std::unique_ptr<Part> solver_;
};

std::optional<OwnUnitPart::Unit> OwnUnitPart::find_unit(const Model& m, const PartDefinition& part,
                                                        std::span<const double> magnitudes) {
  const double longest = max_length(m, part, magnitudes);
  if (!(longest > 0) || std::abs(std::ilogb(longest)) <= far) return {};
  Unit unit{std::ilogb(longest), {}};
  for (const int c : constraints_of(part)) {
    std::optional<LengthPowers> powers = length_powers(m, m.constraints[c]);
    if (!powers) return {};
    unit.powers.push_back(std::move(*powers));
  }
  return unit;
}

OwnUnitPart::OwnUnitPart(const Model& m, const PartDefinition& part, const Unit& unit,
                         const ExplicitKernel& kernel, const BoundKernel& bound,
                         std::span<const double> weights, const Settings& settings,
                         std::unique_ptr<Part> fallback)
    : inputs_(bound.inputs), share_(inputs_.size(), 1) {
  const auto in_own = [&](double value, int power) {
    return std::ldexp(value, -unit.exponent * power);
  };
  const PartType type = describe_type(m, part);
  BoundKernel own = bound;
  std::iota(own.inputs.begin(), own.inputs.end(), 0);
  std::vector<double> own_weights;
  for (std::size_t i = 0; i < type.constraints.size(); ++i) {
    const PartType::Constraint& c = type.constraints[i];
    const Constraint& named = m.constraints[constraints_of(part)[i]];
    const LengthPowers& powers = unit.powers[i];
    for (std::size_t k = 0; k < powers.constants.size(); ++k) {
      double& constant = own.constants[c.first_constant + k];
      constant = in_own(constant, powers.constants[k]);
    }
    for (const int row : c.rows)
      own_weights.push_back(in_own(weights[own_weights.size()], -powers.rows[row]));
    for (std::size_t k = 0; k < c.operands.size(); ++k) {
      const Entity& e = m.entities[named.operands[k]];
      if (is_length(e.kind)) std::fill_n(share_.begin() + c.operands[k], e.size, in_own(1, 1));
    }
  }
  for (int i = 0; i < static_cast<int>(type.inputs.size()); ++i)
    if (type.inputs[i].role == Role::unknown) unknowns_.push_back(i);
  for (std::vector<double>* values : {&own_.q, &own_.qd, &own_.qdd, &own_last_})
    values->resize(inputs_.size());
  part_ = std::make_unique<ExplicitPart>(kernel, own, own_weights, settings,
                                         std::make_unique<InUnitOfAll>(*this, std::move(fallback)));
}

PartResult OwnUnitPart::solve(State& all, std::span<const double> last, Level level) {
  all_ = &all;
  last_ = last;
  take(all);
  for (const int i : unknowns_) own_last_[i] = share_[i] * last[inputs_[i]];
  const PartResult result = part_->solve(own_, own_last_, level);
  give(all);
  return result;
}

void OwnUnitPart::take(const State& all) {
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    own_.q[i] = share_[i] * all.q[inputs_[i]];
    own_.qd[i] = share_[i] * all.qd[inputs_[i]];
    own_.qdd[i] = share_[i] * all.qdd[inputs_[i]];
  }
}

void OwnUnitPart::give(State& all) const {
  for (const int i : unknowns_) {
    all.q[inputs_[i]] = own_.q[i] / share_[i];
    all.qd[inputs_[i]] = own_.qd[i] / share_[i];
    all.qdd[inputs_[i]] = own_.qdd[i] / share_[i];
  }
}

std::vector<int> OwnUnitPart::in_state(std::vector<int> own) const {
  for (int& i : own) i = inputs_[i];
  std::ranges::sort(own);
  return own;
}

PartInputs OwnUnitPart::inputs(PartInputs equations) const {
  PartInputs own = part_->inputs({});
  return {.predicted = in_state(std::move(own.predicted)),
          .unwrapped = in_state(std::move(own.unwrapped)),
          .others = std::move(equations.others),
          .drivers = {}};
}

}  // namespace desmo
