#include <array>
#include <memory>

#include "bench/peers/peer.h"
#include "bench/peers/simbody_conversion.h"

namespace desmo {

namespace {

class SimbodyPeer final : public Peer {
 public:
  SimbodyPeer(const simbody::Tree& tree, simbody::Rates rates)
      : solver_(simbody::make_solver(tree, rates)) {
    for (const simbody::Followed& f : tree.followed)
      for (int i = 0; i < f.components; ++i) answer_.coordinates.push_back(f.coordinate + i);
  }

  void assemble(double t) override {
    solver_->assemble(t);
    take();
  }
  void step(double t) override {
    solver_->step(t);
    take();
  }

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
  return std::make_unique<SimbodyPeer>(simbody::convert(scene, model), rates);
}

}  // namespace

extern const std::array<PeerDefinition, 2> simbody_peers;
constinit const std::array<PeerDefinition, 2> simbody_peers{{
    {"simbody", "Simbody", &simbody::version,
     "joint coordinates in a tree, loop constraints; projectQ to 1e-10, projectU, realize "
     "acceleration",
     &make<simbody::Rates::realized>},
    {"simbody_direct", "Simbody", &simbody::version,
     "the same tree and projectQ; velocities and accelerations from one factorisation of its "
     "constraint matrix",
     &make<simbody::Rates::direct>},
}};

}  // namespace desmo
