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
  void take(int tests = 1) { left_ = std::max(0, left_ - tests); }

 private:
  int left_;
};

}  // namespace desmo
