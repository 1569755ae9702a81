#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/mechanism/motion.h"
#include "cases/mechanism/scene.h"
#include "formulations/base/settings.h"
#include "formulations/base/state.h"
#include "formulations/model/model.h"

namespace desmo {

/// The kinematics of a mechanism solved by another library, or by code written for it by hand. The
/// interface includes no library's headers: what these need of the compiler stays in their file.
class Peer {
 public:
  /// Coordinates of the model that the peer finds, each once, and their values in this order. Some
  /// of the model's may be missing, because they do not follow from the coordinates that the peer
  /// solves for.
  struct Answer : State {
    std::vector<int> coordinates;
  };

  virtual ~Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  /// Announces the grid whose instants follow, in order from the first.
  virtual void expect(const TimeGrid& grid) { static_cast<void>(grid); }

  /// Assembles the mechanism at time t (s) from its nominal position, whatever was solved before.
  /// Throws std::exception, as step() does, when that fails.
  virtual void assemble(double t) = 0;
  /// Solves at time t, starting from the definition's guess in its own coordinates.
  virtual void step(double t) = 0;

  /// Returns the instant solved last.
  const Answer& answer() const { return answer_; }
  /// Returns the iterations of the peer's method for positions, since the last assembly and with
  /// it.
  long iterations() const { return iterations_; }

 protected:
  Peer() = default;

  Answer answer_;
  long iterations_ = 0;
};

/// A peer by its name.
struct PeerDefinition {
  std::string_view name;
  std::string_view library;  ///< library that it is made of, for people
  std::string (*version)();
  std::string_view method;  ///< how it is used, in a sentence
  /// The model of a case. Scene and mechanism (the scene's) must outlive it. Throws
  /// std::invalid_argument when the case is none that it knows.
  std::unique_ptr<Peer> (*make)(const Scene& scene, const Model& model);
  /// The start of its steps: quadratic is q + q̇ h + q̈ h²/2 of the last instant.
  Guess guess = Guess::quadratic;
};

/// Returns the peers of this build: those written by hand and, configured with DESMO_PEERS,
/// libraries.
std::span<const PeerDefinition> peers();

}  // namespace desmo
