#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/paper/options.h"
#include "bench/kit/candidate.h"
#include "bench/kit/process/progress.h"

namespace desmo::paper {

/// How far a run of desmo_bench has come, on standard error: of one experiment after the other
/// first what is verified, then the repetitions. What is left of an experiment follows from how
/// long the verified analyses took, and what is left of the others from how long one thing took so
/// far.
class RunProgress {
 public:
  /// In all experiments.
  explicit RunProgress(int things) : things_left_(things) {}

  /// An experiment begins.
  void begin(const std::vector<Candidate*>& experiment);
  /// One has been through verify() and profile(), whatever became of it, and is to be timed so many
  /// times.
  void verified(const Candidate& one, int repetitions);
  /// All have; timing begins.
  void timing();
  /// One repetition of it has been taken.
  void repeated(const Candidate& one);
  void end();
  /// Makes room on a terminal for other output.
  void clear();

  /// An experiment of so many things is over, in another process.
  void passed(int things);

 private:
  double left_to_verify() const;
  double left_to_repeat() const;
  void one_done(double left_of_experiment);

  int things_left_, things_passed_ = 0;  // those of this experiment are left
  const Stopwatch all_;
  int things_ = 0;  // of this experiment
  std::map<const Candidate*, int> repetitions_left_;
  double work_ = 0, work_verified_ = 0;  // as Candidate::expected_work()
  double to_repeat_ = 0, repeated_ = 0;  // CPU s, by the verified analyses
  int all_repetitions_ = 0;
  std::optional<Progress> stage_;
};

}  // namespace desmo::paper
