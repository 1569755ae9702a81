#include <memory>

#include "bench/peers/peer.h"
#include "bench/peers/simbody_cases.h"
#include "bench/peers/simbody_solver.h"

namespace desmo {

namespace {

class SimbodyPeer final : public Peer {
 public:
  SimbodyPeer(simbody::CaseTree model, simbody::Rates rates)
      : solver_(simbody::make_solver(model.tree, rates)) {
    answer_.coordinates = std::move(model.coordinates);
  }

  void assemble(double t) override {
    solver_->assemble(t);
    take();
  }
  void step(double t) override {
    solver_->step(t);
    take();
  }
  std::string setup() const override { return solver_->setup(); }

 private:
  void take() {
    const auto& [q, qd, qdd] = solver_->values();
    answer_.q = q;
    answer_.qd = qd;
    answer_.qdd = qdd;
    iterations_ = solver_->iterations();
  }

  std::unique_ptr<simbody::Solver> solver_;
};

template <simbody::Rates rates>
std::unique_ptr<Peer> make(const Scene& scene, const Model& model) {
  return std::make_unique<SimbodyPeer>(simbody::case_tree(scene, model), rates);
}

}  // namespace

extern const PeerDefinition simbody_peer, simbody_direct_peer;
const PeerDefinition simbody_peer{
    "simbody", "Simbody", &simbody::version,
    "joint coordinates in a tree, loop constraints; projectQ to 1e-10, projectU, realize "
    "acceleration",
    &make<simbody::Rates::realized>};
const PeerDefinition simbody_direct_peer{
    "simbody_direct", "Simbody", &simbody::version,
    "the same tree and projectQ; velocities and accelerations from one factorisation of its "
    "constraint matrix",
    &make<simbody::Rates::direct>};

}  // namespace desmo
