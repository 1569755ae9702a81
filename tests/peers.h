#pragma once

#include <string_view>

#include "bench/peers/peer.h"
#include "cases/mechanism/names.h"

namespace desmo {

/// Returns a peer; throws std::invalid_argument when there is none.
inline const PeerDefinition& find_peer(std::string_view name) {
  return entry_named(name, peers(), "peer");
}

}  // namespace desmo
