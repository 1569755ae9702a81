#pragma once

#include <span>
#include <vector>

#include "formulations/verification/branch/branch_path.h"
#include "formulations/verification/branch/driver_line.h"

namespace desmo {

/// Follower of paths along which the drivers go straight, on the branch of given positions. All
/// paths share one memory.
class StraightPath {
 public:
  /// The model must outlive this object. Paths do not follow its own motions.
  explicit StraightPath(const Model& model) : m_(model), straight_(model), path_(straight_) {}
  explicit StraightPath(const Model&& model) = delete;
  StraightPath(const StraightPath&) = delete;
  StraightPath& operator=(const StraightPath&) = delete;

  const Model& model() const { return m_; }

  /// Leads positions q (coordinates) from driver values `from` to `to` (drivers), with half of a
  /// budget that other paths share. Returns whether all the way is proven; if not, q does not
  /// change.
  bool lead(std::span<const double> from, std::span<const double> to, std::vector<double>& q,
            TestBudget& budget);

  /// Finds the instant at arc s of a line, near positions q, with rates with respect to s. Returns
  /// null if it is not proven. Valid until the next call.
  const CertifiedInstant* find(const DriverLine& line, double s, std::span<const double> q);

 private:
  const Model& m_;
  Model straight_;
  BranchPath path_;
};

}  // namespace desmo
