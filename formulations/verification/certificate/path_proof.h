#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"
#include "formulations/verification/certificate/certificate.h"
#include "formulations/verification/certificate/hermite.h"

namespace desmo {

/// An instant whose positions are certified.
struct CertifiedInstant {
  double time = 0;                             ///< [s]
  PerLevel<std::span<const double>> values{};  ///< all coordinates; empty above the levels it has
  std::span<const double> radius{};            ///< of the positions (Certificate::radius)
  std::span<const Level>
      levels{};  ///< up to which each coordinate is solved; empty: as far as values
};

/// A copy of a certified instant, in memory of its own.
struct InstantCopy {
  double time = 0;                         ///< [s]
  PerLevel<std::vector<double>> values{};  ///< (coordinates), or empty
  std::vector<double> radius{};            ///< of the positions (coordinates), or empty

  InstantCopy() = default;
  /// Takes memory for all levels.
  explicit InstantCopy(int coordinates) : radius(coordinates) {
    for (const Level level : all_levels) values[level].resize(coordinates);
  }

  /// Copies an instant, no view of this, but for its levels. Takes memory at most the first time.
  void assign(const CertifiedInstant& instant) {
    time = instant.time;
    for (const Level level : all_levels)
      values[level].assign(instant.values[level].begin(), instant.values[level].end());
    radius.assign(instant.radius.begin(), instant.radius.end());
  }
  /// Returns the instant, which is valid until the copy changes. levels: as in CertifiedInstant.
  CertifiedInstant view(std::span<const Level> levels = {}) const {
    return {time, {values.position, values.velocity, values.acceleration}, radius, levels};
  }
};

/// What is proven of the motion between two instants.
struct PathCertificate {
  bool proven = false;
  /// Structural group of the block whose proof failed; no_position where none has, or a knot lies
  /// in the step.
  GroupId group = no_position;
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
  ~PathProof();

  /// Proves the step between two instants of the model's motions, from.time < to.time. A step that
  /// contains a knot of a spline has no proof, since its driver is no polynomial. Allocates
  /// nothing.
  PathCertificate prove(const CertifiedInstant& from, const CertifiedInstant& to);

  /// Returns the radius of the tube of each coordinate after a proof.
  std::span<const double> radius() const;
  /// Returns the tube's centre line at a time, up to rounding.
  double centre(int coordinate, double time) const;
  /// Returns the tube's centre line as a polynomial of s, and the time at s [s].
  const Quintic<double>& path(int coordinate) const;
  double time_at(double s) const;

 private:
  class Tube;
  std::unique_ptr<Tube> tube_;
};

}  // namespace desmo
