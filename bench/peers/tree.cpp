// Models that an expert would write by hand for each of the two cases, in relative coordinates.

#include <Eigen/Core>
#include <array>
#include <stdexcept>
#include <string>

#include "bench/peers/peer.h"
#include "bench/peers/tree/tree_peer.h"

namespace desmo {

namespace {

std::string version() {
  return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
         std::to_string(EIGEN_MINOR_VERSION);
}

template <Guess guess>
std::unique_ptr<Peer> make(const Scene& scene, const Model& model) {
  if (scene.mechanism.name == "four_bar") return tree::make_four_bar(scene, model);
  if (scene.mechanism.name == "truck_suspension") return tree::make_truck(scene, model, guess);
  throw std::invalid_argument("tree: no model of '" + scene.mechanism.name + "'");
}

constexpr std::string_view library = "by hand with Eigen",
                           method =
                               "relative coordinates of a tree for this mechanism alone, loop "
                               "after loop: closed forms, and Newton's method on two angles of "
                               "each axle until our tolerance is met";

}  // namespace

extern const std::array<PeerDefinition, 2> tree_peers;
constinit const std::array<PeerDefinition, 2> tree_peers{{
    {"tree", library, &version, method, &make<Guess::quadratic>},
    {"tree_adams8", library, &version, method, &make<Guess::adams8>, Guess::adams8},
}};

}  // namespace desmo
