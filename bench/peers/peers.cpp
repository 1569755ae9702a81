#include "bench/peers/peer.h"

namespace desmo {

// The list of this build: one line DESMO_PEER(name) each, written by CMake.
#define DESMO_PEER(name) extern const PeerDefinition name##_peer;
#include "peers.inc"
#undef DESMO_PEER

std::span<const PeerDefinition* const> peers() {
  static const std::vector<const PeerDefinition*> table{
#define DESMO_PEER(name) &name##_peer,
#include "peers.inc"
#undef DESMO_PEER
  };
  return table;
}

}  // namespace desmo
