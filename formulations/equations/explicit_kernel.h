#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

namespace desmo {

/// What a solution must satisfy.
struct ExplicitLimits {
  double tolerance2;       ///< on ‖Φ‖₂² of the part's own equations, each times its weight
  double core_tolerance2;  ///< on that of the residuals of a core, smaller: others grow from them
  int max_iterations;      ///< of Newton–Raphson on a core
};

/// What comparing values of type T gives: bool, or one for each lane.
template <class T>
using Mask = decltype(std::declval<T>() < std::declval<T>());

template <class M>
bool all(const M& mask) {
  if constexpr (std::is_same_v<M, bool>)
    return mask;
  else
    return all_of(mask);
}
template <class M>
bool any(const M& mask) {
  if constexpr (std::is_same_v<M, bool>)
    return mask;
  else
    return any_of(mask);
}

/// Numbers of an anchor: an angle, its sine and its cosine.
inline constexpr int anchor_size = 3;

/// A part that a kernel is bound to, or one in each lane. What it points to outlives it.
template <class T>
struct ExplicitBinding {
  const int* in;    ///< position in q, q̇ and q̈ of each local input, fixed entities behind
  const T* c;       ///< dimensions
  const T* f;       ///< what ExplicitKernel::fold makes of them
  const T* branch;  ///< ±1: the side of each square root
  const T* w;       ///< 1/magnitude of each equation
  T* anchors;       ///< for each angle one not far from it, which the kernel moves with it so that
                    ///< sines need not be evaluated anew; zeros: none yet
  ExplicitLimits limits;
};

/// Where an explicit order ended; for a single part small enough for registers.
template <class T>
struct ExplicitResult {
  T residual2;       ///< ‖Φ‖₂² of the part's own equations, each times its weight
  int iterations;    ///< of Newton–Raphson, the most of any core; 0 when there is none
  Mask<T> accepted;  ///< residual2 is small enough, and no divisor or square root is too small
};

/// Where several of one type ended, solved one after the other.
struct ExplicitRunResult {
  int accepted;      ///< how many, up to the first that was not
  int iterations;    ///< the most of any of them …
  long all;          ///< … and of all together
  double residual2;  ///< of these together
};

/// A kernel for one part, over and over: what is between two parts is nothing but a loop.
template <ExplicitResult<double> (*solve)(double*, double*, double*,
                                          const ExplicitBinding<double>&)>
ExplicitRunResult solve_run(double* q, double* qd, double* qdd,
                            const ExplicitBinding<double>* parts, int count) {
  int accepted = 0, iterations = 0;  // in registers: stores to the state might change a result
  long all = 0;
  double residual2 = 0;
  for (; accepted < count; ++accepted) {
    const ExplicitResult<double> r = solve(q, qd, qdd, parts[accepted]);
    if (!r.accepted) break;
    iterations = std::max(iterations, r.iterations);
    all += r.iterations;
    residual2 += r.residual2;
  }
  return {accepted, iterations, all, residual2};
}

/// Generated code that solves one type of group or block (see PartType) in explicit order:
/// unknowns in closed form one after the other, Newton–Raphson on what is left, velocities and
/// accelerations by differentiation.
struct ExplicitKernel {
  std::string_view name;                       ///< of the group it was first seen in
  std::string_view fingerprint;                ///< PartType::fingerprint
  std::span<const std::string_view> branches;  ///< what each square root determines
  std::span<const int> unknowns;               ///< local inputs that are written
  std::span<const int> torn;                   ///< those of them that Newton–Raphson starts from
  std::span<const int> angles;                 ///< those that stay near the last, with an anchor
  int folded;                                  ///< values that depend on dimensions alone

  /// f: those values, from the dimensions c.
  void (*fold)(const double* c, double* f);
  /// branch: those on which a solved position lies.
  void (*find_branches)(const double* q, const int* in, const double* c, double* branch);

  /// Positions of the unknowns on those branches, and their rates up to a level, of `count` parts
  /// in their order, up to the first that is not accepted; of that one they are unspecified.
  using Solve = ExplicitRunResult(double* q, double* qd, double* qdd,
                                  const ExplicitBinding<double>* parts, int count);
  std::array<Solve*, 3> solve;  ///< by Level
};

/// The explicit kernel that desmo was built with for a fingerprint, or null.
const ExplicitKernel* find_explicit_kernel(std::string_view fingerprint);

}  // namespace desmo
