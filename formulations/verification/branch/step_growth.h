#pragma once

namespace desmo {

/// Rule for when to try a step of twice the length. Where all steps are equally hard, every other
/// step would be a failing try. So after each try that failed, twice as many steps must succeed
/// before the next one. An easier part of a motion is thus noticed late by at most as many steps as
/// were taken before.
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
  int wait_ = 1, left_ = 0;  // steps between two tries; steps left before the next try
  bool is_try_ = false;      // the present step is twice as long as the one before
};

}  // namespace desmo
