#pragma once

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "formulations/codegen/eliminate/sums.h"
#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// How the C++ of an emitter looks.
struct EmissionStyle {
  std::string type = "double";
  std::string functions = "std::";  ///< before sqrt and abs
  std::string angles = "std::";     ///< before sin and cos
  /// Expressions of dimensions alone become elements of an array `f`, computed beforehand.
  bool folds_dimensions = false;
};

/// Writes expressions of the current graph as straight-line C++. What is used more than once
/// becomes a variable, declared before its first use; inputs are declared by the caller.
class Emitter {
 public:
  /// outputs: every expression that will be asked for, so that uses can be counted.
  Emitter(std::ostream& out, std::string indent, const std::vector<Expr>& outputs,
          EmissionStyle style = {});

  /// Writes to another place from now on. With declarations kept apart, variables are only
  /// assigned there, and declared() has their names.
  void write_to(std::ostream& out, std::string indent, bool declarations_apart = false);
  const std::vector<std::string>& declared() const { return names_apart_; }
  /// A named variable with this value; from now on, the expression is written as its name.
  void define(const std::string& name, Expr e);
  /// A named variable with the value that this text has, known as late as that (see Readiness).
  void assign(const std::string& name, const std::string& text, int known);
  /// From now on the expression, an input most of all, is written so.
  void name(Expr e, std::string text);
  const EmissionStyle& style() const { return style_; }
  /// When the expression is known, as it is written here.
  int known(Expr e) const { return readiness_.of(e.id()); }
  /// Expressions of dimensions that were written as elements of `f`, in order.
  const std::vector<Expr>& folded() const { return folded_; }

  /// Declares what the expressions share, and whatever is long, once.
  void prepare(const std::vector<Expr>& expressions);
  /// The text of an expression, after prepare().
  std::string text(Expr e) const;
  /// Nodes of the inputs that the expressions read, in graph order.
  static std::vector<int> inputs_of(const std::vector<Expr>& expressions);

 private:
  void declare(int id);
  std::string text(int id) const;
  std::string operand(int id, int least) const;
  std::string sum(int id) const;
  std::string product(int id) const;
  IsWhole has_name() const {
    return [this](int id) { return names_.contains(id); };
  }

  std::ostream* out_;
  std::string indent_;
  EmissionStyle style_;
  bool declarations_apart_ = false;
  std::vector<int> uses_;
  std::map<int, std::string> names_;  // of what has been declared
  std::vector<std::string> names_apart_;
  std::vector<Expr> folded_;
  mutable Readiness readiness_;  // remembers what it has found
};

/// A double as C++ source that reads back to the same value.
std::string literal(double value);

}  // namespace desmo::generate
