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

/// A solver of a mechanism's kinematics that is another library, or code written by hand for this
/// mechanism. The interface includes no library's headers: what these need of the compiler stays in
/// the files that include them.
class Peer {
 public:
  /// Coordinates of the model that the peer finds, each once, and their values in this order. The
  /// constructor lists them. Where a library solves, some of the model's may be missing, because
  /// they do not follow from its own.
  struct Answer : State {
    std::vector<int> coordinates;
  };

  virtual ~Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  /// Announces the grid whose instants follow, in order from the first.
  virtual void expect(const TimeGrid& grid) { static_cast<void>(grid); }

  /// Assembles the mechanism at time t [s] from its nominal position, whatever was solved before.
  /// Throws std::exception, as step() does, when that fails.
  virtual void assemble(double t) = 0;
  /// Solves at time t [s], starting from PeerDefinition::guess in the peer's own coordinates.
  virtual void step(double t) = 0;

  /// Returns the instant solved last.
  const Answer& answer() const { return answer_; }
  /// Returns the number of iterations of the peer's method for positions, from the last assembly
  /// on, which is included.
  long iterations() const { return iterations_; }

 protected:
  Peer() = default;

  Answer answer_;
  long iterations_ = 0;
};

/// A kind of peer, with the function that makes one.
struct PeerDefinition {
  std::string_view name;
  std::string_view library;  ///< library that it uses, for people
  std::string (*version)();
  std::string_view method;  ///< how it is used, in a sentence
  /// Makes a peer for a case. Scene and model must outlive it. Throws std::invalid_argument when it
  /// has no model of the case.
  std::unique_ptr<Peer> (*make)(const Scene& scene, const Model& model);
  /// Prediction with which its steps start: quadratic is q + q̇ h + q̈ h²/2 of the last instant.
  Guess guess = Guess::quadratic;
  bool is_by_hand = false;  ///< written for the cases alone; finds every coordinate of the model
};

/// Returns the peers of this build: those written by hand and, configured with DESMO_PEERS,
/// libraries.
std::span<const PeerDefinition> peers();

}  // namespace desmo
