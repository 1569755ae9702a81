#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/verification/certificate/block_batch.h"
#include "formulations/verification/certificate/certificate.h"
#include "formulations/verification/certificate/certified_instant.h"
#include "formulations/verification/certificate/hermite.h"
#include "formulations/verification/certificate/preconditioner.h"

namespace desmo {

/// Result of PathProof::prove(): whether two instants are proven to lie on one smooth motion.
struct PathCertificate {
  bool proven = false;
  /// Structural group of the block whose proof failed. no_position: no proof failed, or a knot lies
  /// in the step.
  GroupId group = no_position;
};

/// The path of a coordinate and the tube about it: eight numbers, two registers.
struct alignas(32) CoordinatePath {
  Quintic<double> path{};
  double gap = 0;     ///< bound on the distance, at either end, to any point of the certified box
  double radius = 0;  ///< of the tube; infinite: not proven

  void set(const LaneNumbers& low, const LaneNumbers& high) {
    low.store(path.data());
    high.store(path.data() + LaneNumbers::count);  // c[4], c[5], gap, radius
  }
};
static_assert(sizeof(CoordinatePath) == 8 * sizeof(double));

/// Time along a path [s]: middle + half s for s in [−1, 1]. Both doubles count as exact; the range
/// covers both ends.
struct TimeSpan {
  double middle, half;

  TimeSpan(double from, double to) : middle(from + (to - from) / 2) {
    half = std::nextafter(std::max(to - middle, middle - from), INFINITY);
  }
  double s(double time) const { return (time - middle) / half; }
  double time(double s) const { return middle + half * s; }
};

/// Returns the first knot of a driver's spline between two times [s], both excluded; nothing if
/// there is none. A step is to be split there. The first and the last knot of a spline do not
/// count: its outer cubics reach beyond them.
std::optional<double> first_knot(const Model& model, double from, double to);

/// Prover that two certified instants lie on one smooth motion. In a tube about a path between
/// them, Φ(q, t) = 0 has exactly one solution for each time. It is smooth, and both instants are on
/// it. So the step has not jumped to another branch, nor passed a singular position.
///
/// The path p(s), s in [−1, 1], is the Hermite polynomial through both instants. It is a quintic
/// where accelerations are solved, a cubic where velocities are, else a chord. Krawczyk's test is
/// that of a certificate (certificate.h), for all s at once. With the inputs' paths y(s) and their
/// errors δ,
///
///   −Y Φ(p(s), y(s)) − Y Φ_h(p(s), y(s) + δ) δ + (I − Y Φ_φ(p(s) + X, y(s) + δ)) X  inside X
///
/// where Y is an approximate inverse of Φ_φ at s = 0. Φ along the path is evaluated in Taylor
/// models of degree 5. Φ_φ and Φ_h are in those of degree 1: in differences of points that move
/// together the linear parts cancel. Drivers are Taylor models of their motions, so a driver that
/// turns back within the step is inside. X covers the certified boxes of both instants, so the
/// solution in the tube is the one that the certificates speak of.
///
///   PathProof path(model, certifier);
///   if (path.prove(before, now).proven) …   // `now` continues `before`
///
/// Costs one to three steps of `global_automatic_klu`.
class PathProof {
 public:
  /// Allocates everything. Shares blocks and their memory with the certifier: one thread at a time
  /// may use both. Both have the same model, which must outlive this object.
  PathProof(const Model& model, const Certifier& certifier);
  PathProof(const PathProof&) = delete;
  PathProof& operator=(const PathProof&) = delete;

  /// Proves the step between two instants of the model's motions, from.time < to.time. A step
  /// across an inner knot of a spline is not proven: its Taylor model would be that of one piece.
  /// Allocates nothing.
  PathCertificate prove(const CertifiedInstant& from, const CertifiedInstant& to);

  /// Returns the radius of a coordinate's tube after a proof.
  double radius(int coordinate) const { return paths_[coordinate].radius; }
  /// Returns the tube's centre line at a time [s], up to rounding.
  double centre(int coordinate, double time) const;
  /// Returns the tube's centre line as a polynomial of s.
  const Quintic<double>& path(int coordinate) const { return paths_[coordinate].path; }
  /// Returns the time [s] at an s of the step tested last.
  double time_at(double s) const { return span_.time(s); }

 private:
  // In coordinate_paths.cpp.
  void find_paths(const CertifiedInstant& from, const CertifiedInstant& to);
  void find_driven_paths();

  void gather(const BlockBatch& batch);
  void add_homotopy(const BlockBatch& batch);
  void find_image(const BlockBatch& batch);
  void contract(BlockBatch& batch);
  LaneMask prove(BlockBatch& batch);

  const Model& m_;
  std::shared_ptr<BlockSchedule> schedule_;
  TimeSpan span_{-1, 1};
  std::vector<CoordinatePath> paths_;  // of each coordinate

  // Values of the present batch.
  std::vector<PathValue> states_, phi_;
  std::vector<PathSlope> slopes_;
  std::vector<LaneNumbers> curved_;       // bounds on the terms of states_ above degree 1
  std::vector<LaneNumbers> errors_;       // radii of δ of the inputs (m)
  std::vector<LaneNumbers> gaps_;         // CoordinatePath::gap of the unknowns (n)
  std::vector<LaneNumbers> image_;        // bounds on |Y Φ + Y Φ_h δ| (n)
  std::vector<LaneNumbers> uncertainty_;  // |Φ| + radii of Φ_h × |δ|, then workspace (n)
  std::vector<LaneNumbers> trial_;        // radii of X (n)
  std::vector<LaneNumbers> contracted_;   // bounds on |(I − Y Φ_φ) X| (n)
  Preconditioner preconditioner_;
  const Preconditioner* y_ = nullptr;
};

}  // namespace desmo
