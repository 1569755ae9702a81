#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/experiments/size/problem.h"
#include "bench/kit/verification.h"
#include "formulations/id.h"

namespace desmo::size {

/// One formulation that solves a problem: verified before it is timed.
class Contender {
 public:
  /// id: as parse_id takes it; the tolerance is the problem's, which must outlive the contender.
  Contender(const Problem& problem, std::string_view id);

  /// Solves the whole motion and compares it with what is right, where that is known; what may
  /// differ grows as the problem's tolerance does beyond the usual one. What goes wrong ends in
  /// `message`.
  void verify();
  /// Takes one more sample of the CPU time of a step: the whole motion with its assembly, drivers
  /// and delivery into plain vectors, by the number of instants; over and over until that took
  /// `least` seconds, by a formulation made anew on a fresh heap. Nothing unless it is right.
  void time(double least);

  bool is_right() const { return verified_ && message.empty(); }

  const std::string id;
  std::string message;  ///< what is wrong
  bench::Errors errors;
  double iterations_per_step = 0, residual = 0;
  /// That the formulation keeps on the heap, what libraries keep for it included: no step touches
  /// more. 0: not known.
  long bytes = 0;
  std::vector<double> seconds_per_step;  ///< samples

 private:
  void compare();
  double measure(double least);

  const Problem& problem_;
  Configuration configuration_;
  bool verified_ = false;
};

}  // namespace desmo::size
