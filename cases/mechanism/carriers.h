#pragma once

#include <span>
#include <vector>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// The bodies that carry each point, or each vector. Memory is linear in the number of pairs,
/// queries are logarithmic.
class Carriers {
 public:
  /// Indices of an entity (a point or a vector) and of a body that carries it.
  struct Pair {
    int entity, body;
    auto operator<=>(const Pair&) const = default;
  };

  /// Collects the pairs of all bodies. carried: &Body::points or &Body::vectors.
  Carriers(const Mechanism& mechanism, std::vector<int> Mechanism::Body::*carried);

  bool carries(int body, int entity) const { return find({entity, body}) >= 0; }
  bool is_carried(int entity) const { return !of(entity).empty(); }
  std::span<const Pair> of(int entity) const;  ///< pairs of the entity, one for each carrying body
  int find(Pair pair) const;                   ///< index in pairs(); -1: not carried
  std::span<const Pair> pairs() const { return pairs_; }  ///< all pairs, ascending

 private:
  std::vector<Pair> pairs_;
};

}  // namespace desmo
