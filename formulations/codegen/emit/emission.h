#pragma once

#include <functional>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "formulations/codegen/eliminate/sums.h"
#include "formulations/codegen/record/expression.h"
#include "formulations/codegen/record/recording.h"

namespace desmo::generate {

/// The style of emitted C++.
struct EmissionStyle {
  std::string type = "double";      ///< type of the variables
  std::string functions = "std::";  ///< prefix of sqrt and abs
  std::string angles = "std::";     ///< prefix of sin and cos
  /// Writes expressions of dimensions alone as elements of an array `f`, computed beforehand.
  bool folds_dimensions = false;
};

/// A writer of graph expressions as straight-line C++. An expression that is long or used more than
/// once becomes a variable, declared before its first use. The caller declares the inputs.
class Emitter {
 public:
  /// Counts how often each expression is used. outputs: every expression that will be written.
  Emitter(std::ostream& out, std::string indent, const std::vector<Expr>& outputs,
          EmissionStyle style = {});

  /// Redirects the output. declarations_apart: variables are assigned and not declared; declared()
  /// returns their names, so that they can be declared elsewhere.
  void write_to(std::ostream& out, std::string indent, bool declarations_apart = false);
  const std::vector<std::string>& declared() const { return names_apart_; }
  /// Writes a variable with the value of e. An input of that name gets the arrival time of e.
  void define(const std::string& name, Expr e);
  /// Writes a variable with the value of `text`. known: cycle at which that value is known (see
  /// ArrivalTimes).
  void assign(const std::string& name, const std::string& text, int known);
  /// Sets the text by which an expression, such as an input, is written from now on.
  void name(Expr e, std::string text);
  const EmissionStyle& style() const { return style_; }
  /// Returns the cycle at which the expression is known (see ArrivalTimes).
  int known(Expr e) const { return arrival_.of(e.id()); }
  /// Returns the expressions of dimensions that were written as elements of `f`, in order.
  const std::vector<Expr>& folded() const { return folded_; }

  /// Declares variables for shared and for long subexpressions not yet declared.
  void prepare(const std::vector<Expr>& expressions);
  /// Returns the text of an expression; call prepare() first.
  std::string text(Expr e) const;

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
  std::map<int, std::string> names_;      // text by which each named node is written
  std::vector<std::string> names_apart_;  // variables to be declared elsewhere
  std::vector<Expr> folded_;
  mutable ArrivalTimes arrival_;  // mutable, because it caches the cycles that it computes
};

/// Returns the text that reads each position and rate of a part from arrays q, qd and qdd, by node.
/// place: returns what follows the array's name for an input of the part, as "[in[3]]".
std::map<int, std::string> places_of(const RecordedPart& part,
                                     const std::function<std::string(int input)>& place);

/// Declares the inputs that expressions read, in graph order, and adds them to `declared`. Leaves
/// out inputs that are in `declared` already and those without a place.
/// - declaration: what stands before a name, as "const double"
/// - places: text that reads an input, by its node, as "q[in[3]]" (places_of())
void declare_inputs(std::ostream& out, const std::vector<Expr>& expressions,
                    const std::string& declaration, const std::map<int, std::string>& places,
                    std::set<int>& declared);

/// Returns a double as C++ source that reads back to the same value. Throws std::invalid_argument
/// when it is not finite.
std::string literal(double value);

}  // namespace desmo::generate
