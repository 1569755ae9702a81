#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "bench/kit/delivery.h"
#include "bench/kit/digests.h"
#include "formulations/formulation.h"
#include "formulations/verification/reference/reference.h"

namespace desmo::bench {

/// Largest differences over all coordinates and compared instants, absolute, in units of the case,
/// unlike the relative errors of formulations/verification.
struct Errors {
  int instants = 0;
  double position = 0, velocity = 0, acceleration = 0;
};

/// Raises `largest` to |a − b| where that is larger; NaN counts as infinitely wrong.
void widen(double& largest, double a, double b);

/// Allowed differences from the quadruple-precision reference, in units of the case: of q, q̇
/// and q̈ (`instants` means nothing here).
inline constexpr Errors allowed{0, 1e-9, 1e-8, 1e-7};

/// Differences from a reference, and a digest of what was compared, in units of what is allowed.
struct Comparison {
  Errors errors;
  std::string results;
};

/// A delivery that also copies the results q, q̇, q̈ at the times of a reference, to compare them.
class ComparingObserver : public Delivery {
 public:
  ComparingObserver(std::size_t coordinates, Level level,
                    std::span<const ReferenceInstant> reference)
      : Delivery(coordinates, level), reference_(reference), came_(reference.size()) {}

  Flow observe(const Instant& instant) noexcept override;
  virtual Comparison compare() const = 0;

 protected:
  /// Calls compare(reference, results) for each instant of the reference that was delivered.
  template <class Compare>
  void for_each(Compare&& compare) const {
    for (std::size_t r = 0; r < came_.size(); ++r)
      if (!came_[r].q.empty()) compare(reference_[r], came_[r]);
  }

 private:
  std::span<const ReferenceInstant> reference_;
  std::vector<State> came_;  // empty: not yet
};

/// Compares a whole mechanism with a reference.
class VerifyingObserver final : public ComparingObserver {
 public:
  explicit VerifyingObserver(std::span<const ReferenceInstant> reference);
  Comparison compare() const override;
};

/// Returns the verification failure, in words; empty when errors are within so many times what is
/// allowed.
std::string verification_failure(const Errors& errors, std::size_t expected_instants,
                                 double times = 1);

/// Throws std::runtime_error, naming the mechanism, where `floor` exceeds 1e-20: neither solution
/// is a reference then. floor: the difference of two quadruple-precision solutions at each level,
/// relative to the mechanism's size, largest speed and largest acceleration.
void require_agreement(const Model& model, const PerLevel<double>& floor);

/// Returns which parts are not what the formulation's id says; empty: none. Without generated code
/// a part falls back to automatic equations, and is not to be timed under that id.
std::string missing_code(const Formulation& formulation);

/// Quadruple-precision references at instants spread over a motion, made once for each case, size
/// and grid and shared by all formulations.
class ReferenceCache {
 public:
  /// Throws std::runtime_error when there is none: see make_reference and require_agreement.
  std::span<const ReferenceInstant> get(const Model& model, const TimeGrid& grid);

 private:
  struct Key {
    std::string case_name;
    int coordinates;
    double start, step;  // of the grid [s]
    int instants;
    auto operator<=>(const Key&) const = default;
  };
  std::map<Key, Reference> cache_;
};

}  // namespace desmo::bench
