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

/// Largest differences over all compared coordinates and instants. Those of the suite's own cases
/// are absolute, in units of the case: the cases are of ordinary size, so that one allowed
/// difference fits them all, and a scale, itself computed, cannot hide an error. Those of a user's
/// scene are relative (Compared::scale), like the errors of formulations/verification.
struct Differences : PerLevel<double> {
  int instants = 0;  ///< number of instants compared
};

/// Raises `largest` to |a − b| where that is larger; NaN counts as an infinite difference.
void raise_to_difference(double& largest, double a, double b);

/// Largest allowed differences (≤) of q, q̇ and q̈ from the reference, in units of the case or, where
/// differences are relative, of their scales.
inline constexpr PerLevel<double> allowed_difference{1e-9, 1e-8, 1e-7};

/// The result of a comparison with a reference.
struct Comparison {
  Differences errors;
  std::string results;  ///< digest of the values, each as a multiple of its allowed difference
};

/// A value that is compared: its index in what is delivered and in the reference, its level, and
/// the scale by which a difference is divided.
struct Compared {
  int delivered, reference;
  Level level;
  double scale = 1;
};

/// Returns all values up to a level, one level after the other. Each coordinate has the same index
/// in what is delivered and in the reference.
///
/// scales: scale of each coordinate at each level (coordinate_scales); empty: 1.
std::vector<Compared> all_compared(std::size_t coordinates, Level highest,
                                   const PerLevel<std::vector<double>>& scales = {});

/// A delivery that also copies the results q, q̇, q̈ at the times of a reference, to compare them.
class ComparingObserver final : public Delivery {
 public:
  /// coordinates, level: number of coordinates and level of the request. compared: values of that
  /// level or below. The reference must outlive the observer.
  ComparingObserver(std::size_t coordinates, Level level,
                    std::span<const ReferenceInstant> reference, std::vector<Compared> compared);

  Flow observe(const Instant& instant) noexcept override;
  /// Compares the copies with the reference. Leaves out instants that were not observed.
  Comparison compare() const;

 private:
  struct Copy {
    bool was_delivered = false;
    State state{};
  };

  std::span<const ReferenceInstant> reference_;
  std::vector<Copy> copies_;  // one for each instant of the reference
  const std::vector<Compared> compared_;
};

/// Returns the scales (Scales) of all coordinates, at each level, in the motion of the reference; 1
/// for fixed coordinates, and for rates where nothing moves.
PerLevel<std::vector<double>> coordinate_scales(const Model& model,
                                                std::span<const ReferenceInstant> reference);

/// Returns the verification failure, in words; empty when all errors are at most `times` the
/// allowed differences, and as many instants were compared as expected.
std::string verification_failure(const Differences& errors, std::size_t expected_instants,
                                 double times = 1);

/// Throws std::runtime_error, naming the mechanism, where `floor` exceeds 1e-20 at a level. floor:
/// the difference of two quadruple-precision solutions at each level, relative to the mechanism's
/// size, largest speed and largest acceleration. Where it is larger, neither is a reference.
void require_agreement(const Model& model, const PerLevel<double>& floor);

/// Returns how many parts lack the generated code that the formulation's id promises, in words;
/// empty: none. Such a part falls back to automatic equations, and must not be timed under that id.
std::string missing_code(const Formulation& formulation);

/// Returns `count` times [s] of a grid, 2 or more. Cuts the grid into count − 1 equal pieces. Takes
/// the grid's first time, a time from each further piece, and the grid's last. Their distances are
/// irregular. At regular ones all might be multiples of a stride, so that no interpolated instant
/// would be compared.
std::vector<double> spread_times(const TimeGrid& grid, int count);

/// Returns the quadruple-precision reference of a motion at up to 51 instants, first and last among
/// them. For a formulation that interpolates (Settings::stride above 1) these are spread_times(),
/// else evenly spaced. A reference is made once for each model and grid, shared by all
/// formulations, and kept to the end of the process. Call it from one thread at a time. Throws
/// std::runtime_error when there is none: see make_reference and require_agreement.
std::span<const ReferenceInstant> shared_reference(const Model& model, const TimeGrid& grid,
                                                   int stride = 1);

}  // namespace desmo::bench
