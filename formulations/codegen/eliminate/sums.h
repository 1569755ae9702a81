#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// Estimated times at which expressions of the current graph are known, in processor cycles from
/// the first instruction. The estimate assumes that an operation waits for its operands alone,
/// never for a free unit of the processor. Sums and products are ordered by these times, so rounded
/// latencies suffice.
class ArrivalTimes {
 public:
  /// Sets the cycle at which an input is known. Without this call the input is known at cycle 0.
  void define(const std::string& input, int cycles) { defined_[input] = cycles; }

  /// Returns the cycle at which the value of a node is known.
  int of(int id);

 private:
  int find(const Node& n);

  std::map<std::string, int> defined_;
  std::vector<int> found_;  // cycle of each node; negative: not yet computed
};

/// A predicate of nodes: true for a node to keep as one term or factor, false to expand it.
using IsWhole = std::function<bool(int)>;

/// A term of a sum.
struct Term {
  int id;
  bool subtracted;
};

/// Flattens nested sums, differences and negations into terms. They are ordered by arrival, so
/// that early terms are added while late ones are computed. The first two are swapped when only the
/// first is subtracted, so that the sum need not begin with a negation.
std::vector<Term> terms_of(int id, ArrivalTimes& arrival, const IsWhole& is_whole);

/// Flattens nested products into factors, ordered by arrival.
std::vector<int> factors_of(int id, ArrivalTimes& arrival, const IsWhole& is_whole);

}  // namespace desmo::generate
