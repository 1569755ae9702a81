#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "bench/peers/peer.h"
#include "formulations/modelling/model.h"

namespace desmo {

/// A rival of this build.
inline const PeerDefinition& find_peer(std::string_view name) {
  for (const PeerDefinition* peer : peers())
    if (peer->name == name) return *peer;
  throw std::invalid_argument("no peer " + std::string(name));
}

/// What it needed for a scene.
inline std::string setup_by(std::string_view name, const Scene& scene) {
  const Mechanism mechanism = make_mechanism(scene);
  return find_peer(name).make(scene, mechanism)->setup();
}

}  // namespace desmo
