// Which bodies carry which points or vectors.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// The carriers of all points, or of all vectors. Linear space, logarithmic queries.
class Carriers {
 public:
  /// Entity and the body that carries it.
  struct Pair {
    int entity, body;
    auto operator<=>(const Pair&) const = default;
  };

  /// `carried` is &Body::points or &Body::vectors.
  Carriers(const Mechanism& mechanism, std::vector<int> Mechanism::Body::*carried);

  bool carries(int body, int entity) const { return find({entity, body}) >= 0; }
  bool is_carried(int entity) const { return !of(entity).empty(); }
  std::span<const Pair> of(int entity) const;             ///< one for each body that carries it
  int find(Pair pair) const;                              ///< position in pairs(); -1: not carried
  std::span<const Pair> pairs() const { return pairs_; }  ///< ascending

 private:
  std::vector<Pair> pairs_;
};

}  // namespace desmo
