#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// When expressions of the current graph are known, in cycles of a processor that makes nothing
/// wait but for its operands. Only what is later than what matters: latencies are rounded ones of
/// what there is today.
class Readiness {
 public:
  /// An input that the code itself defines is known then, and not from the beginning.
  void define(const std::string& input, int cycles) { defined_[input] = cycles; }

  int of(int id);

 private:
  int find(const Node& n);

  std::map<std::string, int> defined_;
  std::vector<int> found_;  // by node; negative: not yet
};

/// Whether a node of a sum or product is to stand in it as it is, and not what it is made of.
using IsWhole = std::function<bool(int)>;

/// What is added in a sum, or subtracted.
struct Term {
  int id;
  bool subtracted;
};

/// The terms of a sum, a difference or a negated one, with those of nested ones. In the order in
/// which they are known, so that the sum follows the last of them by one operation; the first is
/// not subtracted where the second may change places with it.
std::vector<Term> terms_of(int id, Readiness& readiness, const IsWhole& is_whole);

/// The factors of a product, in the same way.
std::vector<int> factors_of(int id, Readiness& readiness, const IsWhole& is_whole);

}  // namespace desmo::generate
