// Table of the bodies that carry points or vectors.
#pragma once

#include <span>
#include <vector>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// Carriers of all points, or of all vectors. Memory is linear, queries are logarithmic.
class Carriers {
 public:
  /// An entity and a body that carries it.
  struct Pair {
    int entity, body;
    auto operator<=>(const Pair&) const = default;
  };

  /// `carried` is &Body::points or &Body::vectors.
  Carriers(const Mechanism& mechanism, std::vector<int> Mechanism::Body::*carried);

  bool carries(int body, int entity) const { return find({entity, body}) >= 0; }
  bool is_carried(int entity) const { return !of(entity).empty(); }
  std::span<const Pair> of(int entity) const;             ///< one pair for each carrying body
  int find(Pair pair) const;                              ///< position in pairs(); -1: not carried
  std::span<const Pair> pairs() const { return pairs_; }  ///< ascending

 private:
  std::vector<Pair> pairs_;
};

}  // namespace desmo
