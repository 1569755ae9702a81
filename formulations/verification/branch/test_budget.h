#pragma once

#include <algorithm>

namespace desmo {

/// Number of tests that remain to a search. All paths of the search share it, so it bounds the time
/// that the search takes, however many paths it tries. A path proof is a test, and so is any other
/// work that costs as much, such as a refinement.
class TestBudget {
 public:
  explicit TestBudget(int tests) : left_(tests) {}

  int left() const { return left_; }
  void take(int tests = 1) {
    tests = std::min(tests, left_);
    left_ -= tests;
    if (whole_) whole_->take(tests);
  }
  /// Returns half of what is left, for one path or try: others are left the rest. What it takes is
  /// taken from this budget, too, which must outlive it.
  TestBudget half() {
    TestBudget part((left_ + 1) / 2);
    part.whole_ = this;
    return part;
  }

 private:
  int left_;
  TestBudget* whole_ = nullptr;
};

}  // namespace desmo
