#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/verification/certificate/certificate.h"
#include "formulations/verification/certificate/certified_instant.h"
#include "formulations/verification/certificate/hermite.h"
#include "formulations/verification/certificate/path_equations.h"
#include "formulations/verification/certificate/preconditioner.h"

namespace desmo {

/// Proof about the motion between two instants.
struct PathCertificate {
  bool proven = false;
  /// Structural group of the block whose proof failed; no_position where none has, or a knot lies
  /// in the step.
  GroupId group = no_position;
};

/// The path of a coordinate and the tube about it, in two registers.
struct alignas(32) CoordinatePath {
  Quintic<double> path{};
  double gap = 0;     ///< from the path to the instants
  double radius = 0;  ///< of the tube; infinite: not proven

  void set(const LaneNumbers& low, const LaneNumbers& high) {
    low.store(path.data());
    high.store(path.data() + LaneNumbers::count);  // and what follows it
  }
};
static_assert(sizeof(CoordinatePath) == 8 * sizeof(double));

/// Time along a path, s in [−1, 1]: middle + half s, with exact doubles whose range covers both
/// ends.
struct TimeSpan {
  double middle, half;

  TimeSpan(double from, double to) : middle(from + (to - from) / 2) {
    half = std::nextafter(std::max(to - middle, middle - from), INFINITY);
  }
  double s(double time) const { return (time - middle) / half; }
  double time(double s) const { return middle + half * s; }
};

/// Returns the first knot of a driver's spline between two times [s], both excluded: where a step
/// is to be split. The first and the last knot of a table are none: its outer cubics reach beyond.
std::optional<double> first_knot(const Model& model, double from, double to);

/// Proves that two certified instants lie on one smooth motion: between them, Φ(q, t) = 0 has
/// exactly one solution for each time in a tube about a path, it is smooth, and both instants are
/// on it. So the step has not jumped to another branch, nor passed a singular position.
///
/// The path p(s), s in [−1, 1], is the Hermite polynomial through both instants: a quintic where
/// accelerations are solved, a cubic where velocities are, else a chord. Krawczyk's test is that of
/// a certificate (certificate.h), for all s at once. With the inputs' paths y(s) and their errors
/// δ,
///
///   −Y Φ(p(s), y(s)) − Y Φ_h(p(s), y(s) + δ) δ + (I − Y Φ_φ(p(s) + X, y(s) + δ)) X  inside X
///
/// where Y is the inverse of Φ_φ in the middle. Φ along the path is evaluated in Taylor models, Φ_φ
/// and Φ_h in those of degree 1: what turns with a body while the step lasts then stays small.
/// Drivers are Taylor models of their motions, so that one which turns back within the step is
/// inside. X holds the distance of the path from both instants and their radii, so the solution in
/// the tube is the one that the certificates speak of.
///
///   PathProof path(model, certifier);
///   if (path.prove(before, now).proven) …   // `now` continues `before`
///
/// Costs one to three steps of `global_automatic_klu`.
class PathProof {
 public:
  /// Allocates everything. Shares the blocks of the model, and of a homotopy, with a certifier, so
  /// that one thread at a time may use both. The model must outlive this.
  PathProof(const Model& model, const Certifier& certifier);
  PathProof(const PathProof&) = delete;
  PathProof& operator=(const PathProof&) = delete;

  /// Proves the step between two instants of the model's motions, from.time < to.time. A step
  /// across an inner knot of a spline has no proof: it would follow one piece alone. Allocates
  /// nothing.
  PathCertificate prove(const CertifiedInstant& from, const CertifiedInstant& to);

  /// Returns the radius of the tube of each coordinate after a proof.
  std::span<const double> radius() const { return radius_; }
  /// Returns the tube's centre line at a time, up to rounding.
  double centre(int coordinate, double time) const;
  /// Returns the tube's centre line as a polynomial of s, and the time at s [s].
  const Quintic<double>& path(int coordinate) const { return paths_[coordinate].path; }
  double time_at(double s) const { return span_.time(s); }

 private:
  using Value = PathEquations::Value;
  using Slope = PathEquations::Slope;

  // In coordinate_paths.cpp.
  void find_paths(const CertifiedInstant& from, const CertifiedInstant& to);
  void find_driven_paths();

  void gather(const BlockBatch& batch, const PathEquations& equations);
  void add_homotopy(const BlockBatch& batch);
  void find_image(const BlockBatch& batch, const PathEquations& equations);
  void contract(BlockBatch& batch, const PathEquations& equations);
  LaneMask prove(BlockBatch& batch, const PathEquations& equations);

  const Model& m_;
  std::shared_ptr<BlockSchedule> schedule_;
  std::vector<PathEquations> equations_;  // of each batch, in their order
  TimeSpan span_{-1, 1};
  std::vector<CoordinatePath> paths_;  // of each coordinate
  std::vector<double> radius_;         // of their tubes

  // Values of the present batch.
  std::vector<Value> states_, phi_;
  std::vector<Slope> slopes_;
  std::vector<LaneNumbers> curved_;       // what slopes_ lack of states_
  std::vector<LaneNumbers> errors_;       // δ of the inputs (m)
  std::vector<LaneNumbers> gaps_;         // of the unknowns (n)
  std::vector<LaneNumbers> image_;        // −Y Φ − Y Φ_h δ (n)
  std::vector<LaneNumbers> uncertainty_;  // of the equations (n)
  std::vector<LaneNumbers> trial_;        // radii of X (n)
  std::vector<LaneNumbers> contracted_;   // (I − Y Φ_φ) X (n)
  Preconditioner preconditioner_;
  const Preconditioner* y_ = nullptr;
};

}  // namespace desmo
