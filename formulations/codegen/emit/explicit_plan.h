#pragma once

#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "formulations/codegen/emit/explicit_motion.h"
#include "formulations/codegen/order/explicit_order.h"

namespace desmo::generate {

/// The data from which the functions of one explicit kernel are written.
struct ExplicitPlan {
  /// Finds the explicit order and its rates in the current graph. type and part must outlive the
  /// plan.
  ExplicitPlan(const PartType& type, const RecordedPart& part);

  const PartType& type;
  const RecordedPart& part;
  std::vector<OrderSection> order;
  std::vector<SectionMotion> motion;  ///< by section of the order
  /// Squared norm of each section's residuals, each times the weights of its equations.
  std::vector<Expr> residual2;
  std::vector<Root> roots;  ///< square roots of all definitions, in order
  std::map<int, std::string>
      places;  ///< C++ text that reads a position or rate, by node: "q[in[3]]"

  /// Return the torn unknowns and the angles with a bearing, in solution order. The kernel reads
  /// their last positions.
  std::vector<int> torn() const;
  std::vector<int> angles() const;
};

}  // namespace desmo::generate
