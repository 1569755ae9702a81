// Ceres Solver on the natural-coordinate constraints. Each constraint is a residual block, with the
// derivatives of our constraint kinds; each unknown entity is a parameter block.

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

#include "bench/peers/peer.h"
#include "formulations/constraints/constraints.h"
#include "formulations/model/magnitudes.h"
#include "formulations/model/partition.h"
#include "formulations/motion/internals.h"
#include "formulations/motion/prediction/driver_source.h"
#include "formulations/motion/prediction/guess.h"
#include "formulations/variants.h"

namespace desmo {

namespace {

/// Velocities and accelerations are not Ceres' business. They come from the same linear systems as
/// ours, with the fastest sparse solver, so that nothing slower of ours counts against it.
constexpr const char* formulation_of_rates = "global_automatic_klu";

/// The equations of one constraint that the model keeps, as functions of its unknown entities.
template <class Kind>
class ConstraintCost final : public ceres::CostFunction {
 public:
  /// fixed: address of each operand's value; null for an unknown, whose value Ceres gives.
  /// weights: 1/magnitude of each row, so that the norm that ends the iterations is that of ours.
  ConstraintCost(const Constraint& constraint,
                 const std::array<const double*, Kind::operand_sizes.size()>& fixed,
                 const std::array<double, Kind::rows>& weights)
      : fixed_(fixed), weights_(weights) {
    std::ranges::transform(constraint.constants, std::back_inserter(constants_), &Derived::value);
    int kept = 0;
    for (int r = 0; r < Kind::rows; ++r)
      place_[r] = (constraint.left_out >> r & 1U) != 0 ? -1 : kept++;
    set_num_residuals(kept);
    for (std::size_t k = 0; k < fixed_.size(); ++k) {
      block_[k] = fixed_[k] ? -1 : static_cast<int>(parameter_block_sizes().size());
      if (!fixed_[k]) mutable_parameter_block_sizes()->push_back(Kind::operand_sizes[k]);
    }
  }

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    std::array<const double*, Kind::operand_sizes.size()> x;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = fixed_[k] ? fixed_[k] : parameters[block_[k]];
    std::array<double, Kind::rows> phi;
    const auto numbers = constants_at<Kind>(constants_.data(), x.data());
    Kind::residual(x.data(), numbers.data(), phi.data());
    for (int r = 0; r < Kind::rows; ++r)
      if (place_[r] >= 0) residuals[place_[r]] = weights_[r] * phi[r];
    if (!jacobians) return true;

    for (std::size_t k = 0; k < x.size(); ++k)
      if (double* values = target(jacobians, k))
        std::fill_n(values, num_residuals() * Kind::operand_sizes[k], 0.0);
    Kind::jacobian(x.data(), numbers.data(), [&](int r, int operand, int i, double value) {
      double* values = target(jacobians, operand);
      if (values && place_[r] >= 0)
        values[place_[r] * Kind::operand_sizes[operand] + i] = weights_[r] * value;
    });
    return true;
  }

 private:
  double* target(double** jacobians, int operand) const {
    return block_[operand] < 0 ? nullptr : jacobians[block_[operand]];
  }

  std::array<const double*, Kind::operand_sizes.size()> fixed_;
  std::array<double, Kind::rows> weights_;
  std::array<int, Kind::operand_sizes.size()> block_;  // parameter block of each operand; -1: fixed
  std::vector<double> constants_;
  std::array<int, Kind::rows> place_;  // index of each row among the residuals; -1: left out
};

/// Ends Ceres' iterations as Newton's are ended: when the norm of the equations is small enough.
class StopAtTolerance final : public ceres::IterationCallback {
 public:
  explicit StopAtTolerance(double tolerance) : cost_(tolerance * tolerance / 2) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    return summary.cost < cost_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  double cost_;  // limit (<) of ‖Φ‖²/2
};

/// Returns options with a trust region so large that no step is damped. Far from singular positions
/// that is Newton's method, which is the fastest here.
ceres::Solver::Options newton(ceres::IterationCallback& stop, int max_iterations) {
  ceres::Solver::Options o;
  o.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  o.sparse_linear_algebra_library_type = ceres::SUITE_SPARSE;
  o.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  o.initial_trust_region_radius = o.max_trust_region_radius = 1e16;
  o.jacobi_scaling = false;
  o.function_tolerance = o.gradient_tolerance = o.parameter_tolerance = 0;
  o.max_num_iterations = max_iterations;
  o.num_threads = 1;
  o.logging_type = ceres::SILENT;
  o.callbacks.push_back(&stop);
  return o;
}

class CeresPeer final : public Peer {
 public:
  explicit CeresPeer(const Model& m)
      : model_(m),
        rates_(make_formulation(find_variant(formulation_of_rates), m, settings_)),
        // Slightly stricter than our parts, which then accept Ceres' positions without iterations.
        stop_(0.99 * settings_.tolerance /
              std::sqrt(static_cast<double>(parts_of(*rates_).size()))),
        options_(newton(stop_, settings_.max_iterations)),
        problem_(problem_options()) {
    state_.resize(m.state_size());
    const std::vector<bool> driven = independent_coordinates(m);
    is_unknown_.resize(m.entities.size());
    for (std::size_t e = 0; e < m.entities.size(); ++e)
      is_unknown_[e] = !m.is_at_rest(static_cast<EntityId>(e)) && !driven[m.entities[e].first];
    const Magnitudes magnitudes(m);
    for (int c = 0; c < static_cast<int>(m.constraints.size()); ++c)
      if (!m.groups[m.constraints[c].group].constant && kept_rows(m.constraints[c]) > 0)
        add(c, magnitudes);
    for (const auto& part : parts_of(*rates_))  // a global formulation has one part that moves
      if (!part.definition.constant) ranges_ = ranges_of(part.definition.unknowns);
    answer_.coordinates.resize(m.coordinates());
    for (int i = 0; i < m.coordinates(); ++i) answer_.coordinates[i] = i;
    answer_.resize(m.coordinates());
  }

  void assemble(double t) override {
    iterations_ = 0;
    std::ranges::copy(model_.estimate, state_.q.begin());
    std::ranges::copy(model_.fixed_values, state_.q.begin() + model_.coordinates());
    std::ranges::fill(state_.qd, 0.0);
    std::ranges::fill(state_.qdd, 0.0);
    solve_parts(true);
    solve(t);
  }

  void step(double t) override {
    const StepHistory history{t - time_, 0, Level::acceleration};
    Prediction(Guess::quadratic, history)(ranges_, state_, state_, state_.q.data());
    solve(t);
  }

 private:
  static ceres::Problem::Options problem_options() {
    ceres::Problem::Options o;
    o.disable_all_safety_checks = true;
    return o;
  }

  void add(int position, const Magnitudes& magnitudes) {
    const Constraint& c = model_.constraints[position];
    visit_kind(c.kind, [&]<class Kind>(Kind) {
      std::array<const double*, Kind::operand_sizes.size()> fixed{};
      std::vector<double*> blocks;
      for (std::size_t k = 0; k < fixed.size(); ++k) {
        double* value = state_.q.data() + model_.state_index(c.operands[k]);
        if (is_unknown_[c.operands[k]])
          blocks.push_back(value);
        else
          fixed[k] = value;
      }
      std::array<double, Kind::rows> weights;
      for (int r = 0; r < Kind::rows; ++r) weights[r] = 1 / magnitudes.of({position, r});
      problem_.AddResidualBlock(new ConstraintCost<Kind>(c, fixed, weights), nullptr, blocks);
    });
  }

  void solve(double t) {
    time_ = t;
    write_drivers(model_, t, state_);
    ceres::Solver::Summary summary;
    ceres::Solve(options_, &problem_, &summary);
    if (summary.termination_type != ceres::USER_SUCCESS) throw std::runtime_error(summary.message);
    iterations_ += static_cast<long>(summary.iterations.size()) - 1;
    if (solve_parts(false) > 0) throw std::logic_error("ceres: it stopped above the tolerance");
    deliver();
  }

  /// Solves the constant parts, or else the others for velocities and accelerations: at positions
  /// that Ceres has found, their solvers take no iteration. Returns the largest number of
  /// iterations that a part has taken.
  int solve_parts(bool constant) {
    int iterations = 0;
    for (const auto& part : parts_of(*rates_)) {
      if (part.definition.constant != constant) continue;
      const PartResult result = part.solver->solve(state_, state_.q, Level::acceleration);
      if (result.status != Status::solved) throw std::runtime_error("singular Jacobian");
      iterations = std::max(iterations, result.iterations);
    }
    return iterations;
  }

  void deliver() {
    const int n = model_.coordinates();
    std::copy_n(state_.q.begin(), n, answer_.q.begin());
    std::copy_n(state_.qd.begin(), n, answer_.qd.begin());
    std::copy_n(state_.qdd.begin(), n, answer_.qdd.begin());
  }

  const Model& model_;
  Settings settings_;
  std::unique_ptr<Formulation> rates_;
  StopAtTolerance stop_;
  ceres::Solver::Options options_;
  ceres::Problem problem_;
  State state_;  // its q contains Ceres' parameter blocks
  std::vector<bool> is_unknown_;
  std::vector<IndexRange> ranges_;  // indices of the unknowns in q
  double time_ = 0;                 // time of the last instant [s]
};

std::string version() { return CERES_VERSION_STRING; }

std::unique_ptr<Peer> make(const Scene&, const Model& model) {
  return std::make_unique<CeresPeer>(model);
}

}  // namespace

extern const PeerDefinition ceres_peer;
constinit const PeerDefinition ceres_peer{
    "ceres", "Ceres Solver", &version,
    "natural coordinates, analytic derivatives, undamped sparse normal equations; velocities and "
    "accelerations from our own linear systems",
    &make};

}  // namespace desmo
