#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "bench/peers/peer.h"
#include "formulations/modelling/modelling.h"

namespace desmo {

/// Returns a peer; throws std::invalid_argument when there is none.
inline const PeerDefinition& find_peer(std::string_view name) {
  for (const PeerDefinition& peer : peers())
    if (peer.name == name) return peer;
  throw std::invalid_argument("no peer " + std::string(name));
}

}  // namespace desmo
