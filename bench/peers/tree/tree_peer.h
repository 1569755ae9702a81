#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/peers/peer.h"
#include "bench/peers/tree/moving.h"

namespace desmo::tree {

/// A peer written by hand, which writes what it finds straight into its answer.
class TreePeer : public Peer {
 protected:
  /// Announces that the coordinates of these entities are delivered after those announced before.
  /// Throws std::invalid_argument when the model has no such entity.
  void will_deliver(const Model& model, const std::vector<std::string>& entities) {
    for (const std::string& name : entities) {
      const Entity& e = model.entities[model.find(name)];
      for (int i = 0; i < e.size; ++i) answer_.coordinates.push_back(e.first + i);
    }
    answer_.resize(answer_.coordinates.size());
  }

  /// Returns a writer of everything that was announced, which starts with the first coordinate.
  AnswerWriter writer() { return {answer_.q.data(), answer_.qd.data(), answer_.qdd.data()}; }
};

/// Makes a peer of truck_suspension, which solves one axle after the other. guess: prediction of
/// the two angles of each axle that Newton's method finds.
std::unique_ptr<Peer> make_truck(const Scene& scene, const Model& model, Guess guess);

/// Makes a peer of four_bar, which solves one dyad after the other in closed form.
std::unique_ptr<Peer> make_four_bar(const Scene& scene, const Model& model);

}  // namespace desmo::tree
