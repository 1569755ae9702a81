#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/peers/peer.h"
#include "cases/mechanism/names.h"

namespace desmo {

/// Returns a peer; throws std::invalid_argument when there is none.
inline const PeerDefinition& find_peer(std::string_view name) {
  return entry_named(name, peers(), "peer");
}

/// Returns the names of all peers that are written by hand, or of all others.
inline std::vector<std::string> names_of_peers(bool by_hand) {
  std::vector<std::string> names;
  for (const PeerDefinition& p : peers())
    if (p.is_by_hand == by_hand) names.emplace_back(p.name);
  return names;
}

}  // namespace desmo
