#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cases/mechanism/scene.h"
#include "formulations/base/observer.h"
#include "formulations/base/per_level.h"
#include "formulations/model/model.h"
#include "formulations/model/plan.h"

namespace desmo {

/// A scalar that is computed from solved coordinates.
struct Measure {
  /// Names of its values at the levels that are asked for; empty: it has none there.
  PerLevel<std::string> names{};
  EntityKind kind;                     ///< kind of quantity, which tells the unit
  std::optional<EntityKind> per = {};  ///< of a ratio: the kind that it is divided by
};

/// The measures that a scene requests (Scene::measures). They are functions of coordinates and
/// rates: formulations do not know them.
///
/// - a rotation from the drawing, or that of a body's own frame: in the plane an angle in (−π, π],
///   in space a vector along its axis, at most π long. Its rates are ω and α in the ground's frame
/// - a joint's turn about its axis, in (−π, π], and travel along it, of the second body in the
///   first, from the drawing
/// - a ratio of two rates; where both vanish, that of the accelerations. NaN where only the second
///   rate vanishes, where both and the second acceleration do, and without the levels it needs
///
///   const Plan plan = make_plan(whole, outputs_of(scene, whole));  // with what measures read
///   Measures measures(scene, plan.model);
///   // In an observer, of an instant with all coordinates:
///   const double omega = measures.extend(instant).qd[plan.model.coordinates() + k];
class Measures {
 public:
  /// A function that writes the values of a measure, and of further ones after it, at an instant.
  using Rule = std::function<void(const Instant&, std::span<PerLevel<double>>)>;

  /// A velocity v, divided by its nominal magnitude (nominal_magnitudes()), vanishes where
  ///
  ///   |v| <= min_rate V,  V: largest |velocity| of a driver, divided likewise
  ///
  /// and an acceleration a where |a| <= min_rate (A + V²), A: largest |acceleration| of a driver.
  /// Rounding errors of coordinates are proportional to the drivers' rates. A driver whose rate is
  /// 0 by its motion counts as 0 in V and A: its rate consists of rounding. When the scale on the
  /// right is 0, everything vanishes.
  static constexpr double min_rate = 1e-10;

  /// Source of the drivers' rates: the model's motions, or rows of numbers, which are exact.
  enum class DrivenBy { motions, rows };

  /// Throws std::invalid_argument, naming the measure,
  /// - for a body or joint whose points and vectors do not tell its rotation, unless only patterns
  ///   ask for it that match others which do,
  /// - for a coordinate that is fixed, and
  /// - for a name that the model or another measure has.
  Measures(const Scene& scene, const Model& model, DrivenBy driven_by = DrivenBy::motions);

  const std::vector<Measure>& list() const { return list_; }
  /// Returns the entities that the measures read, each with the highest level read.
  const std::vector<Output>& inputs() const { return inputs_; }

  /// Returns the instant with the values of the measures appended to q, q̇ and q̈, at the levels
  /// that it has; the instant as it is where there are no measures, or no positions. Valid until
  /// the next call.
  Instant extend(const Instant& instant);

 private:
  int coordinates_;
  std::vector<Measure> list_;
  std::vector<Output> inputs_;
  std::vector<std::pair<std::size_t, Rule>> rules_;  // position of the first measure of each rule
  std::vector<PerLevel<double>> values_;
  PerLevel<std::vector<double>> extended_;
};

/// Returns the outputs that a scene requests, in terms of its whole model; after them those that
/// its measures read. Throws what Measures throws.
std::vector<Output> outputs_of(const Scene& scene, const Model& whole);

}  // namespace desmo
