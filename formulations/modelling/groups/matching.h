#pragma once

#include <vector>

#include "formulations/modelling/groups/group_order.h"
#include "formulations/modelling/groups/restrictions.h"
#include "formulations/structure/csparse.h"

namespace desmo {

/// A maximum matching between the restrictions of a mechanism and the freedoms of its bodies. It is
/// the Dulmage–Mendelsohn decomposition of their incidence matrix (restrictions × freedoms).
class Matching {
 public:
  /// Computes the matching. restrictions must outlive it.
  Matching(const RigidBodies& rigid, const std::vector<Restriction>& restrictions);

  /// Returns the number of freedoms that nothing determines.
  int undetermined() const { return form_->cc[1]; }
  /// Returns the rigid bodies that these freedoms belong to, ascending.
  std::vector<int> undetermined_bodies() const { return bodies_of_columns(0, form_->cc[2]); }

  /// Returns a component for each irreducible block. Over-constrained bodies that a restriction
  /// connects form one component.
  Components components() const;

 private:
  void add_irreducible(Components& components) const;
  void add_surplus(Components& components) const;
  std::vector<int> bodies_of_columns(int begin, int end) const;

  const std::vector<Restriction>& all_;
  int bodies_;
  std::vector<int> body_of_freedom_, restriction_of_row_;
  CSparseForm form_;
};

}  // namespace desmo
