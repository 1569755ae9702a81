#pragma once

#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "formulations/generate/expression.h"

namespace desmo::generate {

/// Writes expressions of the current graph as straight-line C++. What is used more than once
/// becomes a variable, declared before its first use; inputs are declared by the caller.
class Emitter {
 public:
  /// outputs: every expression that will be asked for, so that uses can be counted.
  Emitter(std::ostream& out, std::string indent, const std::vector<Expr>& outputs);

  /// Declares what the expressions share, and whatever is long, once.
  void prepare(const std::vector<Expr>& expressions);
  /// The text of an expression, after prepare().
  std::string text(Expr e) const;
  /// Nodes of the inputs that the expressions read, in graph order.
  static std::vector<int> inputs_of(const std::vector<Expr>& expressions);

 private:
  void declare(int id);
  std::string text(int id) const;

  std::ostream& out_;
  std::string indent_;
  std::vector<int> uses_;
  std::set<int> declared_;
};

/// A double as C++ source that reads back to the same value.
std::string literal(double value);

}  // namespace desmo::generate
