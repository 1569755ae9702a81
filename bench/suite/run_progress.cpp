#include "bench/suite/run_progress.h"

#include <algorithm>

namespace desmo::suite {

RunProgress::RunProgress(const std::vector<Timed*>& all) {
  for (const Timed* one : all) work_ += one->expected_work();
  stage_.emplace("verified", static_cast<int>(all.size()));
}

void RunProgress::verified(const Timed& one, int repetitions) {
  work_verified_ += one.expected_work();
  if (one.state == Timed::State::verified) {
    repetitions_left_[&one] = repetitions;
    to_repeat_ += repetitions * one.analysis_seconds;
    all_repetitions_ += repetitions;
  }
  stage_->one_done(left_to_verify() + to_repeat_ * work_ / work_verified_);
}

void RunProgress::timing() {
  stage_.reset();
  if (all_repetitions_ > 0) stage_.emplace("repetitions", all_repetitions_);
}

void RunProgress::repeated(const Timed& one) {
  // Google Benchmark takes a repetition again that was too short for its least time.
  int& left = repetitions_left_[&one];
  if (left == 0) return;
  --left;
  repeated_ += one.analysis_seconds;
  stage_->one_done(left_to_repeat());
}

void RunProgress::clear() {
  if (stage_) stage_->clear();
}

double RunProgress::left_to_verify() const {
  return stage_->elapsed() * (work_ - work_verified_) / work_verified_;
}

double RunProgress::left_to_repeat() const {
  const double pace = repeated_ > 0 ? stage_->elapsed() / repeated_ : 1;
  return std::max(0.0, to_repeat_ - repeated_) * pace;
}

}  // namespace desmo::suite
