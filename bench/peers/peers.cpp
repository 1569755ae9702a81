#include <Eigen/Core>
#include <array>
#include <stdexcept>

#include "bench/peers/peer.h"
#include "bench/peers/tree/tree_peer.h"

namespace desmo {

namespace {

std::string version_of_eigen() {
  return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
         std::to_string(EIGEN_MINOR_VERSION);
}

/// Makes the peer that an expert would write by hand for one of the cases. guess: prediction with
/// which Newton's method starts in a step.
template <Guess guess>
std::unique_ptr<Peer> make_tree(const Scene& scene, const Model& model) {
  if (scene.mechanism.name == "four_bar") return tree::make_four_bar(scene, model);
  if (scene.mechanism.name == "truck_suspension") return tree::make_truck(scene, model, guess);
  throw std::invalid_argument("tree: no model of '" + scene.mechanism.name + "'");
}

constexpr std::string_view by_hand = "by hand with Eigen",
                           tree_method =
                               "relative coordinates of a tree for this mechanism alone, loop "
                               "after loop: closed forms, and Newton's method on two angles of "
                               "each axle until our tolerance is met";

}  // namespace

#ifdef DESMO_PEERS
// Each of these is defined in the file that uses the library.
extern const std::array<PeerDefinition, 2> simbody_peers;
extern const PeerDefinition ceres_peer;
#endif

std::span<const PeerDefinition> peers() {
  static const std::vector<PeerDefinition> table{
      {"tree", by_hand, &version_of_eigen, tree_method, &make_tree<Guess::quadratic>,
       Guess::quadratic, true},
      {"tree_adams8", by_hand, &version_of_eigen, tree_method, &make_tree<Guess::adams8>,
       Guess::adams8, true},
#ifdef DESMO_PEERS
      simbody_peers[0],
      simbody_peers[1],
      ceres_peer,
#endif
  };
  return table;
}

}  // namespace desmo
