// Proven radii against an independent proof: interval Newton of all equations at once in 256 bits,
// in the balls of Arb (Johansson, IEEE Trans. Comput. 66, 2017).

#include <arb_mat.h>
#include <gtest/gtest.h>

#include "formulations/constraints/jet.h"
#include "formulations/model/incidence.h"
#include "formulations/model/partition.h"
#include "formulations/parts/groupwise/double_solution.h"
#include "formulations/verification/certificate/certificate.h"
#include "tests/accuracy/scenes.h"
#include "tests/certificate/arb/ball.h"
#include "tests/certificate/containment.h"

namespace desmo::arb_test {
namespace {

/// A matrix of balls.
class Matrix {
 public:
  Matrix(std::size_t rows, std::size_t columns) {
    arb_mat_init(a_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  Matrix(const Matrix&) = delete;
  ~Matrix() { arb_mat_clear(a_); }
  arb_ptr at(std::size_t i, std::size_t j) { return arb_mat_entry(a_, i, j); }
  arb_mat_struct* get() { return a_; }

 private:
  arb_mat_t a_;
};

using State = std::vector<Jet<Ball>>;

/// All equations of a model, and the states that they are about.
class System {
 public:
  explicit System(const Model& m) : m_(m) {
    for (const PartDefinition& part : make_partition(m, Partition::global)) {
      unknowns_.insert(unknowns_.end(), part.unknowns.begin(), part.unknowns.end());
      equations_.insert(equations_.end(), part.equations.begin(), part.equations.end());
    }
  }

  /// Returns balls that hold the exact solution near the delivered numbers.
  State solve(const ReferenceInstant& delivered) const {
    State x(m_.state_size());
    for (int i = 0; i < m_.coordinates(); ++i) x[i].value = delivered.q[i];
    for (std::size_t i = 0; i < m_.fixed_values.size(); ++i)
      x[m_.coordinates() + i].value = Ball(m_.fixed_value(i));
    for (const Driver& d : m_.drivers) {
      const MotionSample<Ball> z = sample(d.motion, Ball(delivered.time));
      x[m_.entities[d.coordinate].first] = {z.position, z.velocity, z.acceleration};
    }
    Matrix step(unknowns_.size(), 1);
    for (int iteration = 0; iteration < 4; ++iteration) {
      correct(x, &Jet<Ball>::value, step);
      for (std::size_t k = 0; k < unknowns_.size(); ++k) {
        Ball& q = x[unknowns_[k]].value;
        arb_sub(q.get(), q.get(), step.at(k, 0), bits);
        arb_get_mid_arb(q.get(), q.get());
      }
    }
    // Interval Newton: a solution is in q − A(X)⁻¹ Φ(q) where this is inside X, which is larger
    // than what the radii of dimensions leave open.
    const State middle = x;
    for (const int i : unknowns_) arb_add_error_2exp_si(x[i].value.get(), -70);
    correct(x, &Jet<Ball>::value, step, &middle);
    for (std::size_t k = 0; k < unknowns_.size(); ++k) {
      Ball found;
      arb_sub(found.get(), middle[unknowns_[k]].value.get(), step.at(k, 0), bits);
      EXPECT_TRUE(arb_contains_interior(x[unknowns_[k]].value.get(), found.get()));
      x[unknowns_[k]].value = found;
    }
    for (Ball Jet<Ball>::*order : {&Jet<Ball>::first, &Jet<Ball>::second}) {
      correct(x, order, step);
      for (std::size_t k = 0; k < unknowns_.size(); ++k)
        arb_neg((x[unknowns_[k]].*order).get(), step.at(k, 0));
    }
    return x;
  }

 private:
  /// Solves Φ_φ(x) step = Φ or one of its rates, at x or at another state.
  void correct(const State& x, Ball Jet<Ball>::*order, Matrix& step,
               const State* of_phi = nullptr) const {
    const std::size_t n = unknowns_.size();
    Matrix a(n, n), phi(n, 1);
    for (std::size_t row = 0; row < equations_.size(); ++row) {
      const Constraint& c = m_.constraints[equations_[row].constraint];
      visit_kind(c.kind, [&]<class Kind>(Kind) {
        std::array<Jet<Ball>, Kind::constants + 1> constants;
        for (int k = 0; k < Kind::constants; ++k) constants[k] = Jet<Ball>(Ball(c.constants[k]));
        const auto operands = [&](const State& from) {
          return operands_of<Kind>(m_, c, from.data());
        };
        std::array<Jet<Ball>, Kind::rows> all;
        Kind::residual(operands(of_phi ? *of_phi : x).data(), constants.data(), all.data());
        arb_set(phi.at(row, 0), (all[equations_[row].row].*order).get());
        Kind::jacobian(operands(x).data(), constants.data(),
                       [&](int r, int operand, int i, const Jet<Ball>& entry) {
                         const int state = m_.state_index(c.operands[operand]) + i;
                         const auto unknown = std::ranges::find(unknowns_, state);
                         if (r == equations_[row].row && unknown != unknowns_.end())
                           arb_set(a.at(row, unknown - unknowns_.begin()), entry.value.get());
                       });
      });
    }
    ASSERT_TRUE(arb_mat_solve(step.get(), a.get(), phi.get(), bits));
  }

  const Model& m_;
  std::vector<int> unknowns_;
  std::vector<Equation> equations_;
};

TEST(CertificateAndArb, AgreeOnASample) {
  for (const char* name : {"slider_crank", "rssr", "andrews", "double_wishbone", "jansen_leg"}) {
    const Scene scene = library_scene(name);
    const Model m = make_model(scene);
    const System system(m);
    Certifier certifier(m);
    for (const ReferenceInstant& s :
         double_solution(m, sampled(scene.grid, DESMO_SANITIZED ? 2 : 5))) {
      const Certificate c = certifier.certify(instant_of(s));
      ASSERT_TRUE(c.proven) << name;
      const State exact = system.solve(s);
      for (int i = 0; i < m.coordinates(); ++i) {
        // Balls are narrow, but of rates wider than some radii: all equations are eliminated at
        // once.
        const auto expect_held = [&](const Ball& ball, double delivered, double radius) {
          EXPECT_LE(ball.least_distance(delivered), radius) << name << ' ' << i;
          EXPECT_LT(ball.distance(delivered) - ball.least_distance(delivered),
                    0x1p-53 * (1 + std::abs(delivered)))
              << name << ' ' << i;
        };
        expect_held(exact[i].value, s.q[i], c.radius.position[i]);
        expect_held(exact[i].first, s.qd[i], c.radius.velocity[i]);
        expect_held(exact[i].second, s.qdd[i], c.radius.acceleration[i]);
      }
    }
  }
}

}  // namespace
}  // namespace desmo::arb_test
