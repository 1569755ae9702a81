#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "bench/kit/delivery.h"
#include "formulations/base/part.h"
#include "formulations/base/per_level.h"
#include "formulations/formulation.h"
#include "formulations/verification/reference/reference.h"

namespace desmo::bench {

/// Largest differences over all coordinates and compared instants, absolute, in units of the case.
/// The suite's own cases are of ordinary size, so one allowed difference fits them all, and a
/// scale, itself computed, cannot hide an error. Errors of formulations/verification are relative:
/// they judge mechanisms of any size.
struct Differences : PerLevel<double> {
  int instants = 0;
};

/// Raises `largest` to |a − b| where that is larger; NaN counts as infinitely wrong.
void raise_to_difference(double& largest, double a, double b);

/// Largest allowed differences of q, q̇ and q̈ from the quadruple-precision reference, in units of
/// the case.
inline constexpr PerLevel<double> allowed_difference{1e-9, 1e-8, 1e-7};

/// The result of a comparison with a reference.
struct Comparison {
  Differences errors;
  std::string results;  ///< digest of the values compared, each rounded to its allowed difference
};

/// A value that is compared: its place in what is delivered and in the reference, and the scale by
/// which a difference is divided.
struct Compared {
  int delivered, reference;
  Level level;
  double scale = 1;
};

/// Returns all coordinates, each at the same place in both, one level after the other.
///
/// scales: of each coordinate at each level (coordinate_scales); empty: 1.
std::vector<Compared> all_compared(std::size_t coordinates, Level highest,
                                   const PerLevel<std::vector<double>>& scales = {});

/// A delivery that also copies the results q, q̇, q̈ at the times of a reference, to compare them.
class ComparingObserver final : public Delivery {
 public:
  /// coordinates, level: of the request. The reference outlives this.
  /// compared: none above that level.
  ComparingObserver(std::size_t coordinates, Level level,
                    std::span<const ReferenceInstant> reference, std::vector<Compared> compared);

  Flow observe(const Instant& instant) noexcept override;
  Comparison compare() const;

 private:
  struct Copy {
    bool was_delivered = false;
    State state{};
  };

  std::span<const ReferenceInstant> reference_;
  std::vector<Copy> copies_;  // by instant of the reference
  const std::vector<Compared> compared_;
};

/// Returns the scales of coordinates in a motion that the reference samples (Scales); 1 where
/// nothing moves.
PerLevel<std::vector<double>> coordinate_scales(const Model& model,
                                                std::span<const ReferenceInstant> reference);

/// Returns the verification failure, in words. Empty when all errors are at most `times` the
/// allowed differences, at as many instants as expected.
std::string verification_failure(const Differences& errors, std::size_t expected_instants,
                                 double times = 1);

/// Throws std::runtime_error, naming the mechanism, where `floor` exceeds 1e-20: neither solution
/// is a reference then. floor: the difference of two quadruple-precision solutions at each level,
/// relative to the mechanism's size, largest speed and largest acceleration.
void require_agreement(const Model& model, const PerLevel<double>& floor);

/// Returns which parts are not what the formulation's id says; empty: none. Without generated code
/// a part falls back to automatic equations, and is not to be timed under that id.
std::string missing_code(const Formulation& formulation);

/// Returns one time of each of count − 1 equal pieces of the grid, and its last; the first of them
/// all. count: 2 or more. They lie in no regular distances, where all might be multiples of a
/// stride: nothing that is interpolated would be compared.
std::vector<double> spread_times(const TimeGrid& grid, int count);

/// Returns the quadruple-precision reference, at instants spread over the motion, of a formulation
/// that solves every stride-th instant (Settings::stride). It is made once for each model and grid,
/// shared by all formulations, and kept to the end of the process. Call it from one thread at a
/// time. Throws std::runtime_error when there is none: see make_reference and require_agreement.
std::span<const ReferenceInstant> shared_reference(const Model& model, const TimeGrid& grid,
                                                   int stride = 1);

}  // namespace desmo::bench
