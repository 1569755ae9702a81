#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/suite/progress.h"
#include "bench/suite/timed.h"

namespace desmo::suite {

/// How far a run of desmo_bench has come, on standard error: first what is verified, then the
/// repetitions. What is left follows from how long the verified analyses took.
class RunProgress {
 public:
  explicit RunProgress(const std::vector<Timed*>& all);

  /// One has been through verify() and profile(), whatever became of it, and is to be timed so many
  /// times.
  void verified(const Timed& one, int repetitions);
  /// All have; timing begins.
  void timing();
  /// One repetition of it has been taken.
  void repeated(const Timed& one);
  /// Makes room on a terminal for other output.
  void clear();

 private:
  double left_to_verify() const;
  double left_to_repeat() const;

  std::map<const Timed*, int> repetitions_left_;
  double work_ = 0, work_verified_ = 0;  // as Timed::expected_work()
  double to_repeat_ = 0, repeated_ = 0;  // CPU s, by the verified analyses
  int all_repetitions_ = 0;
  std::optional<Progress> stage_;
};

}  // namespace desmo::suite
