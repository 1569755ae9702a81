#pragma once

#include <map>
#include <type_traits>
#include <vector>

namespace desmo {

/// Sums of products of elements of two arrays, cᵢ = Σ u_a v_b over given pairs (a, b). Sums with
/// equally many products are evaluated one after the other, so that branches are predictable.
class SumsOfProducts {
 public:
  struct Pair {
    int a, b;  ///< elements of u and v
  };

  SumsOfProducts() = default;
  /// pairs[i]: products of cᵢ, added in that order.
  explicit SumsOfProducts(const std::vector<std::vector<Pair>>& pairs) {
    std::map<int, std::vector<int>> of_length;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      of_length[static_cast<int>(pairs[i].size())].push_back(static_cast<int>(i));
    for (const auto& [length, sums] : of_length) {
      by_length_.push_back({length, static_cast<int>(sums.size())});
      for (int i : sums) {
        target_.push_back(i);
        pairs_.insert(pairs_.end(), pairs[i].begin(), pairs[i].end());
      }
    }
  }

  /// Overwrites every cᵢ. c must not overlap u and v.
  void operator()(const double* u, const double* v, double* c) const {
    const int* target = target_.data();
    const Pair* pair = pairs_.data();
    for (const SumsOfLength& all : by_length_) {
      const auto add = [&](auto length) {
        for (int i = 0; i < all.sums; ++i, ++target, pair += length) {
          double sum = 0;
          for (int k = 0; k < length; ++k) sum += u[pair[k].a] * v[pair[k].b];
          c[*target] = sum;
        }
      };
      // Sums of up to four products are evaluated without an inner loop.
      const auto is_short = [&]<int... length>(std::integer_sequence<int, length...>) {
        return ((all.length == length && (add(std::integral_constant<int, length>()), true)) ||
                ...);
      };
      if (!is_short(std::integer_sequence<int, 1, 2, 3, 4>())) add(all.length);
    }
  }

 private:
  struct SumsOfLength {
    int length;  // number of products in each sum
    int sums;    // number of sums of this length
  };
  std::vector<SumsOfLength> by_length_;
  std::vector<int> target_;  // i of each sum cᵢ, in order of evaluation
  std::vector<Pair> pairs_;  // pairs in order of evaluation
};

}  // namespace desmo
