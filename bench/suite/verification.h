#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/suite/result_digest.h"
#include "formulations/formulation.h"
#include "formulations/reference.h"

namespace desmo::suite {

/// Largest absolute differences over all coordinates and compared instants.
struct Errors {
  int instants = 0;
  double position = 0, velocity = 0, acceleration = 0;
};

/// Raises `largest` to |a − b| where that is larger; NaN counts as infinitely wrong.
void widen(double& largest, double a, double b);

/// What a formulation may differ from the quadruple-precision reference before it counts as
/// wrong, in units of the case.
inline constexpr Errors allowed{0, 1e-9, 1e-8, 1e-7};

/// Compares the instants it is handed with a reference, where the reference has them, and takes the
/// digest of what it compares, in units of what is allowed.
class VerifyingSink final : public Sink {
 public:
  explicit VerifyingSink(std::span<const ReferenceInstant> reference) : reference_(reference) {}
  void accept(const Instant& instant) override;
  const Errors& errors() const { return errors_; }
  std::string results() { return results_.hex(); }  ///< digest; ends it

 private:
  std::span<const ReferenceInstant> reference_;
  Errors errors_;
  ResultDigest results_;
};

/// Empty when within so many times what is allowed; otherwise what is wrong, in words.
std::string complaint(const Errors& errors, std::size_t expected_instants, double times = 1);

/// Throws std::runtime_error, naming the mechanism, where two quadruple solutions differ by more
/// than 1e-20 of its scales: then neither is a reference.
void require_agreement(const Mechanism& mechanism, const PerLevel<double>& floor);

/// Empty when every part is what the formulation's id says; otherwise which are not: without
/// generated code a part falls back to automatic equations, and is not to be timed under that id.
std::string missing_code(const Formulation& formulation);

/// Quadruple-precision references at instants spread over a motion, made once for each case and
/// size and shared by all its formulations.
class ReferenceCache {
 public:
  /// Throws std::runtime_error when there is none: see make_reference and require_agreement.
  std::span<const ReferenceInstant> get(const Mechanism& mechanism, const TimeGrid& grid);

 private:
  std::map<std::pair<std::string, int>, Reference> cache_;
};

}  // namespace desmo::suite
