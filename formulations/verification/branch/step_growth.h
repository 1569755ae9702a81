#pragma once

namespace desmo {

/// A rule for when to try a longer step. Where every step is equally hard, doubled steps would fail
/// every other time: so after each try that failed, twice as many steps must succeed before the
/// next one. An easier part of a motion is thus found late by at most as many steps as were hard.
class StepGrowth {
 public:
  /// Notes that a step succeeded. Returns whether the next one is to be twice as long.
  bool succeeded() {
    if (is_try_) wait_ = 1;
    is_try_ = left_ == 0;
    if (left_ > 0) --left_;
    return is_try_;
  }
  void failed() {
    if (is_try_) left_ = wait_ = 2 * wait_;
    is_try_ = false;
  }

 private:
  int wait_ = 1, left_ = 0;  // steps; at most twice those that were taken
  bool is_try_ = false;      // the present step is twice as long as the one before
};

}  // namespace desmo
