#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

namespace desmo {

/// Limits that a solution must satisfy.
struct ExplicitLimits {
  double tolerance2;  ///< limit of ‖Φ‖₂² of the part's equations, each times its weight (<)
  /// limit of ‖Φ‖₂² of a core (<): smaller, since later unknowns amplify its error
  double core_tolerance2;
  int max_iterations;  ///< limit of Newton–Raphson iterations on a core
};

/// Type of a comparison of values of type T: bool, or one bool per lane.
template <class T>
using Mask = decltype(std::declval<T>() < std::declval<T>());

/// Returns whether a mask is true in every lane.
template <class M>
bool all(const M& mask) {
  if constexpr (std::is_same_v<M, bool>)
    return mask;
  else
    return all_of(mask);
}

/// Number of values in an anchor: an angle, its sine and its cosine.
inline constexpr int anchor_size = 3;

/// Binding of a kernel to one part, or to one part in each lane. The arrays outlive it.
template <class T>
struct ExplicitBinding {
  const int* in;    ///< position of each local input in q, q̇ and q̈ (fixed entities at the end)
  const T* c;       ///< dimensions
  const T* f;       ///< values that ExplicitKernel::fold makes of c
  const T* branch;  ///< ±1: sign of each square root
  const T* w;       ///< 1/magnitude of each equation
  /// for each unwrapped angle a nearby one, its sine and its cosine (anchor_size values), which
  /// turned_angle() reads and overwrites; zeros: none yet
  T* anchors;
  ExplicitLimits limits;
};

/// Result of an explicit order for one part. It is small enough to be returned in registers.
template <class T>
struct ExplicitResult {
  T residual2;       ///< ‖Φ‖₂² of the part's equations, each times its weight
  int iterations;    ///< largest number of Newton–Raphson iterations of a core; 0: no core
  Mask<T> accepted;  ///< residual2 meets its limit, and no divisor or square root is too small
};

/// Result of solving a chain: several parts of one type one after the other.
struct ExplicitChainResult {
  int accepted;           ///< number of accepted parts before the first that was not
  int iterations;         ///< largest number of iterations of an accepted part
  long total_iterations;  ///< sum over the accepted parts
  double residual2;       ///< sum over the accepted parts
};

/// Solves `count` parts with one kernel in a plain loop, up to the first that is not accepted.
template <ExplicitResult<double> (*solve)(double*, double*, double*,
                                          const ExplicitBinding<double>&)>
ExplicitChainResult solve_chain(double* q, double* qd, double* qdd,
                                const ExplicitBinding<double>* parts, int count) {
  // locals stay in registers: stores to the state might alias a result
  int accepted = 0, iterations = 0;
  long total_iterations = 0;
  double residual2 = 0;
  for (; accepted < count; ++accepted) {
    const ExplicitResult<double> r = solve(q, qd, qdd, parts[accepted]);
    if (!r.accepted) break;
    iterations = std::max(iterations, r.iterations);
    total_iterations += r.iterations;
    residual2 += r.residual2;
  }
  return {accepted, iterations, total_iterations, residual2};
}

/// Generated code that solves one type of group or block (see PartType) in explicit order. Unknowns
/// follow in closed form one after the other. Newton–Raphson solves a *core*, the equations that
/// have no closed form, and starts from its *torn* unknowns. Velocities and accelerations follow by
/// differentiation.
struct ExplicitKernel {
  std::string_view name;         ///< name of the group where it was first met
  std::string_view fingerprint;  ///< PartType::fingerprint
  /// name of the unknown that each square root determines
  std::span<const std::string_view> branches;
  std::span<const int> unknowns;  ///< local inputs that are written
  std::span<const int> torn;      ///< unknowns from which Newton–Raphson starts
  std::span<const int> angles;    ///< unwrapped angles, each with an anchor
  int folded;                     ///< number of values that depend on dimensions alone

  /// Computes these values f from the dimensions c.
  void (*fold)(const double* c, double* f);
  /// Finds the branch of each square root on which a solved position lies.
  void (*find_branches)(const double* q, const int* in, const double* c, double* branch);

  /// Solves `count` parts in order on the branches of their bindings, up to the first that is not
  /// accepted. Overwrites the unknowns' positions and their rates up to a level. Those of a part
  /// that is not accepted are unspecified.
  using Solve = ExplicitChainResult(double* q, double* qd, double* qdd,
                                    const ExplicitBinding<double>* parts, int count);
  std::array<Solve*, 3> solve;  ///< indexed by Level
};

}  // namespace desmo
