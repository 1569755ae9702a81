#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace desmo {

/// Lanes are brought together and apart so many at a time: what registers of 256 bits hold.
inline constexpr int quad = 4;

/// to[l][n] = number which[n] of lane l; as many lanes as there are arrays, a multiple of four.
void unpack(const double* from, std::span<const int> which, std::span<double* const> to);

/// Where values that lanes hold side by side stand in a state, a part in each lane.
class LanePlaces {
 public:
  /// inputs: local inputs, ascending; in: by lane, the position of each local input in the state.
  LanePlaces(std::span<const int> inputs, std::span<const int* const> in);

  /// Of these inputs those that stand, in any lane, where `wanted` says.
  LanePlaces only(const std::vector<bool>& wanted) const;

  /// Number `input` of each lane, from the state, for the inputs given.
  void gather(const double* state, double* to) const;
  /// The other way; only lanes l of which bit l of `which` is set.
  void scatter(const double* from, unsigned which, double* state) const;

 private:
  /// Inputs whose places follow each other in every lane of a quad: the components of an entity, or
  /// the entities of a copy.
  struct Run {
    int first, size;
    std::array<int, quad> place;  // of the first
  };
  static void append(int input, const std::array<int, quad>& place, std::vector<Run>& runs);
  // Compiled for each number of lanes: it is in every address.
  template <std::size_t lanes>
  void gather_lanes(const double* state, double* to) const;
  template <std::size_t lanes>
  void scatter_lanes(const double* from, unsigned which, double* state) const;
  template <std::size_t lanes>
  static void scatter_quad(const std::vector<Run>& runs, const double* from, double* state);
  template <std::size_t lanes>
  static void scatter_lane(const std::vector<Run>& runs, int lane, const double* from,
                           double* state);

  std::vector<std::vector<Run>> quads_;
  std::size_t lanes_;
};

}  // namespace desmo
