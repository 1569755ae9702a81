#include <array>

#include "bench/peers/peer.h"

namespace desmo {

// Each is defined in the file that solves by it.
extern const std::array<PeerDefinition, 2> tree_peers;
#ifdef DESMO_PEERS
extern const std::array<PeerDefinition, 2> simbody_peers;
extern const PeerDefinition ceres_peer;
#endif

std::span<const PeerDefinition> peers() {
  static const std::vector<PeerDefinition> table = [] {
    std::vector<PeerDefinition> all(tree_peers.begin(), tree_peers.end());
#ifdef DESMO_PEERS
    all.insert(all.end(), simbody_peers.begin(), simbody_peers.end());
    all.push_back(ceres_peer);
#endif
    return all;
  }();
  return table;
}

}  // namespace desmo
