#include "bench/peers/simbody_solver.h"

#include <stdexcept>

#include "bench/peers/simbody_tree.h"

namespace desmo::simbody {

namespace {

namespace sim = SimTK;

/// Tolerance on the root mean square of the constraint errors, as Simbody measures them.
constexpr double accuracy = 1e-10;

class RealizingSolver : public Solver {
 public:
  explicit RealizingSolver(const Tree& tree) : tree_(tree), built_(tree) {
    state_ = system().realizeTopology();
    system().realize(state_, sim::Stage::Instance);
    if (state_.getNU() - static_cast<int>(tree_.drivers.size()) != state_.getNQErr())
      throw std::invalid_argument("simbody: " + std::to_string(state_.getNU()) + " mobilities, " +
                                  std::to_string(tree_.drivers.size()) +
                                  " of them prescribed, but " + std::to_string(state_.getNQErr()) +
                                  " loop equations");
    estimate_ = state_.getQ();
    int components = 0;
    for (const Followed& f : tree_.followed) components += f.components;
    for (std::vector<double>& v : values_) v.resize(components);
  }

  void assemble(double t) override {
    iterations_ = 0;
    state_.updU() = 0;
    state_.updQ() = estimate_;
    solve(t);
  }

  void step(double t) override {
    const double h = t - state_.getTime();
    state_.updQ() += h * state_.getQDot() + (h * h / 2) * second_derivative();
    solve(t);
  }

  const std::array<std::vector<double>, 3>& values() const override { return values_; }
  long iterations() const override { return iterations_; }

 protected:
  const sim::MultibodySystem& system() const { return built_.system; }
  const sim::SimbodyMatterSubsystem& matter() const { return built_.matter; }

  /// Solves u, u̇ and what follows from them, at positions that meet the constraints.
  virtual void solve_rates() {
    system().prescribeU(state_);
    system().realize(state_, sim::Stage::Velocity);
    system().projectU(state_, no_estimate_, options_, results_);
    system().realize(state_, sim::Stage::Acceleration);
  }
  /// Return q̈ and a body's acceleration at the last instant.
  virtual const sim::Vector& second_derivative() const { return state_.getQDotDot(); }
  virtual const sim::SpatialVec& acceleration(int body) const {
    return built_.bodies[body].getBodyAcceleration(state_);
  }

  const Tree tree_;
  BuiltTree built_;
  sim::State state_;

 private:
  void solve(double t) {
    state_.setTime(t);
    system().realize(state_, sim::Stage::Time);
    system().prescribeQ(state_);
    system().realize(state_, sim::Stage::Position);
    system().projectQ(state_, no_estimate_, options_, results_);
    iterations_ += results_.getNumIterations();
    solve_rates();
    deliver();
  }

  void deliver() {
    std::size_t at = 0;
    for (const Followed& f : tree_.followed) {
      const sim::Transform& pose = built_.bodies[f.body].getBodyTransform(state_);
      const sim::SpatialVec& velocity = built_.bodies[f.body].getBodyVelocity(state_);
      const sim::SpatialVec& of_body = acceleration(f.body);
      const sim::Vec3 d = pose.R() * sim::Vec3(f.in_body[0], f.in_body[1], f.in_body[2]);
      const sim::Vec3 turning = velocity[0] % d;  // ω × d
      sim::Vec3 q = d, qd = turning, qdd = of_body[0] % d + velocity[0] % turning;
      if (f.is_point) {
        q += pose.p();
        qd += velocity[1];
        qdd += of_body[1];
      }
      for (int i = 0; i < f.components; ++i, ++at) {
        values_[0][at] = q[i];
        values_[1][at] = qd[i];
        values_[2][at] = qdd[i];
      }
    }
  }

  std::array<std::vector<double>, 3> values_;
  long iterations_ = 0;
  sim::Vector estimate_;     // q of the nominal position
  sim::Vector no_estimate_;  // empty: Simbody need not project an error estimate as well
  sim::ProjectOptions options_{accuracy};
  sim::ProjectResults results_;
};

class DirectSolver final : public RealizingSolver {
 public:
  explicit DirectSolver(const Tree& tree) : RealizingSolver(tree), driver_(state_.getNU(), -1) {
    for (std::size_t b = 0; b < tree.bodies.size(); ++b)
      if (tree.bodies[b].driver >= 0)
        driver_[built_.bodies[b].getFirstUIndex(state_)] = tree.bodies[b].driver;
    for (int u = 0; u < state_.getNU(); ++u)
      if (driver_[u] < 0) free_.push_back(u);
    const int n = static_cast<int>(free_.size());
    free_columns_.resize(n, n);
    b_.resize(n);
    x_.resize(n);
    udot_.resize(state_.getNU());
  }

 private:
  void solve_rates() override {
    system().prescribeU(state_);
    matter().calcG(state_, g_);
    for (std::size_t j = 0; j < free_.size(); ++j) free_columns_(j) = g_(free_[j]);
    factors_.factor(free_columns_);
    b_ = 0;
    solve_free(state_.updU());  // G u = 0
    system().realize(state_, sim::Stage::Velocity);

    matter().calcBiasForAccelerationConstraints(state_, b_);
    b_ *= -1;
    for (int u = 0; u < state_.getNU(); ++u)
      if (driver_[u] >= 0) udot_[u] = tree_.drivers[driver_[u]](state_.getTime())[2];
    solve_free(udot_);  // G u̇ = −bias
    matter().calcQDotDot(state_, udot_, qdotdot_);
    matter().calcBodyAccelerationFromUDot(state_, udot_, accelerations_);
  }

  /// Solves G x = b_ for the free components of x, given the driven ones. Overwrites b_.
  void solve_free(sim::Vector& x) {
    for (int u = 0; u < x.size(); ++u)
      if (driver_[u] >= 0) b_ -= x[u] * g_(u);
    factors_.solve(b_, x_);
    for (std::size_t j = 0; j < free_.size(); ++j) x[free_[j]] = x_[j];
  }

  const sim::Vector& second_derivative() const override { return qdotdot_; }
  const sim::SpatialVec& acceleration(int body) const override {
    return accelerations_[built_.bodies[body].getMobilizedBodyIndex()];
  }

  std::vector<int> driver_;  // by mobility: index in Tree::drivers; -1: it is free
  std::vector<int> free_;    // indices of the free mobilities
  sim::Matrix g_, free_columns_;
  sim::FactorLU factors_;
  sim::Vector b_, x_, udot_, qdotdot_;
  sim::Vector_<sim::SpatialVec> accelerations_;
};

}  // namespace

std::unique_ptr<Solver> make_solver(const Tree& tree, Rates rates) {
  if (rates == Rates::direct) return std::make_unique<DirectSolver>(tree);
  return std::make_unique<RealizingSolver>(tree);
}

std::string version() {
  int major = 0, minor = 0, patch = 0;
  SimTK_version_simbody(&major, &minor, &patch);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace desmo::simbody
