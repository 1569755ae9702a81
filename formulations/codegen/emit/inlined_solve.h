#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "formulations/codegen/eliminate/elimination.h"
#include "formulations/codegen/emit/function_writer.h"
#include "formulations/codegen/record/recording.h"
#include "formulations/model/part_type.h"

namespace desmo::generate {

/// The functions `position` and `rates` of a kernel (see Kernel), whose elimination is generated.
class InlinedSolve {
 public:
  /// Records the eliminations (see eliminations()) in the current graph. type and part outlive it.
  InlinedSolve(const PartType& type, const RecordedPart& part, std::size_t max_orders,
               std::size_t first_samples);

  /// Writes the two functions of each order, the last order's first: each leaves to the next order
  /// what it refuses.
  void write(std::ostream& out) const;

 private:
  void write_position(std::ostream& out, FunctionWriter& function, std::size_t order) const;
  void write_rates(std::ostream& out, FunctionWriter& function, std::size_t order) const;
  bool is_last(std::size_t order) const { return order + 1 == orders_.size(); }
  SparseRows jacobian_rows() const;
  std::vector<Expr> known_product(const std::vector<Expr>& rate) const;

  const PartType& type_;
  const RecordedPart& part_;
  const std::vector<int> unknowns_;  // inputs, by column
  const std::vector<Elimination> orders_;
};

}  // namespace desmo::generate
