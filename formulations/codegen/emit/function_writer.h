#pragma once

#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "formulations/codegen/emit/emission.h"
#include "formulations/codegen/record/recording.h"

namespace desmo::generate {

/// A writer of the functions of a part's kernel. They read positions and rates from arrays q, qd
/// and qdd, by the places `in` of the part's inputs.
class FunctionWriter {
 public:
  FunctionWriter(std::ostream& out, const RecordedPart& part) : out_(out) {
    for (std::size_t i = 0; i < part.q.size(); ++i) {
      const std::string place = "[in[" + std::to_string(i) + "]]";
      source_[part.q[i].id()] = "q" + place;
      source_[part.qd[i].id()] = "qd" + place;
      source_[part.qdd[i].id()] = "qdd" + place;
    }
  }

  void open(const std::string& signature) {
    out_ << signature << " {\n";
    declared_.clear();
  }
  void close() { out_ << "}\n\n"; }

  /// Declares the inputs that expressions read, each once in a function.
  void load(const std::vector<Expr>& expressions, const char* declaration = "const double") {
    declare_inputs(out_, expressions, declaration, source_, declared_);
  }
  /// Takes an input for declared: other text of the function has defined a variable of its name.
  void take_for_declared(Expr input) { declared_.insert(input.id()); }

 private:
  std::ostream& out_;
  std::map<int, std::string> source_;  // where an input is read from
  std::set<int> declared_;             // inputs, in the function being written
};

}  // namespace desmo::generate
