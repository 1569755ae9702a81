#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/peers/peer.h"
#include "bench/peers/tree/moving.h"

namespace desmo::tree {

/// A model that writes what it finds straight into its answer.
class TreePeer : public Peer {
 protected:
  /// Announces the coordinates that are delivered next: those of these entities. Throws
  /// std::invalid_argument when the mechanism has no such entity.
  void will_deliver(const Model& model, const std::vector<std::string>& entities) {
    for (const std::string& name : entities) {
      const Entity& e = model.entities[model.find(name)];
      for (int i = 0; i < e.size; ++i) answer_.coordinates.push_back(e.first + i);
    }
    answer_.resize(answer_.coordinates.size());
  }

  /// Returns the writer of everything that was announced, from the beginning.
  AnswerWriter writer() { return {answer_.q.data(), answer_.qd.data(), answer_.qdd.data()}; }
};

/// Makes a peer of truck_suspension, which solves one axle after the other. guess: predicts the two
/// angles of an axle that Newton's method finds.
std::unique_ptr<Peer> make_truck(const Scene& scene, const Model& model, Guess guess);

/// Makes a peer of four_bar, which solves one dyad after the other in closed form.
std::unique_ptr<Peer> make_four_bar(const Scene& scene, const Model& model);

}  // namespace desmo::tree
