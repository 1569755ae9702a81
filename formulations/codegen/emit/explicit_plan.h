#pragma once

#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "formulations/codegen/emit/explicit_motion.h"
#include "formulations/codegen/order/explicit_order.h"

namespace desmo::generate {

/// What the functions of one explicit kernel are written from.
struct ExplicitPlan {
  /// In the current graph; type and part must outlive the plan.
  ExplicitPlan(const PartType& type, const RecordedPart& part);

  const PartType& type;
  const RecordedPart& part;
  std::vector<OrderSection> order;
  std::vector<SectionMotion> motion;  ///< of each section
  /// ‖·‖² of the residuals of each section, each times the weights of the equations it is made of.
  std::vector<Expr> residual2;
  std::vector<Root> roots;  ///< of all definitions, in order
  std::map<int, std::string>
      places;  ///< where a position or rate is read from, by node: "q[in[3]]"

  /// The unknowns that are torn, and those that are angles of a bearing, in the order in which they
  /// are defined: their last positions are read.
  std::vector<int> torn() const;
  std::vector<int> angles() const;

  /// Declares the inputs that expressions read and that are not in `declared`, and adds them there.
  void load(std::ostream& out, const std::vector<Expr>& expressions, const std::string& declaration,
            std::set<int>& declared) const;
};

}  // namespace desmo::generate
