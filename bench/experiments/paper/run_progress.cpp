#include "bench/experiments/paper/run_progress.h"

#include <algorithm>

namespace desmo::paper {

void RunProgress::begin(const std::vector<Candidate*>& experiment) {
  things_ = static_cast<int>(experiment.size());
  for (const Candidate* one : experiment) work_ += one->expected_work();
  stage_.emplace("verified", things_);
}

void RunProgress::verified(const Candidate& one, int repetitions) {
  work_verified_ += one.expected_work();
  if (one.state == Candidate::State::verified) {
    repetitions_left_[&one] = repetitions;
    to_repeat_ += repetitions * one.analysis_seconds;
    all_repetitions_ += repetitions;
  }
  one_done(left_to_verify() + to_repeat_ * work_ / work_verified_);
}

void RunProgress::timing() {
  stage_.reset();
  if (all_repetitions_ > 0) stage_.emplace("repetitions", all_repetitions_);
}

void RunProgress::repeated(const Candidate& one) {
  // Google Benchmark takes a repetition again that was too short for its least time.
  int& left = repetitions_left_[&one];
  if (left == 0) return;
  --left;
  repeated_ += one.analysis_seconds;
  one_done(left_to_repeat());
}

void RunProgress::end() { stage_.reset(); }

void RunProgress::clear() {
  if (stage_) stage_->clear();
}

void RunProgress::passed(int things) {
  things_left_ -= things;
  things_passed_ += things;
}

double RunProgress::left_to_verify() const {
  return stage_->elapsed() * (work_ - work_verified_) / work_verified_;
}

double RunProgress::left_to_repeat() const {
  const double pace = repeated_ > 0 ? stage_->elapsed() / repeated_ : 1;
  return std::max(0.0, to_repeat_ - repeated_) * pace;
}

void RunProgress::one_done(double left_of_experiment) {
  const double each = (all_.elapsed() + left_of_experiment) / (things_passed_ + things_);
  stage_->one_done(left_of_experiment + each * (things_left_ - things_));
}

}  // namespace desmo::paper
