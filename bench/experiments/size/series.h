#pragma once

#include <regex>
#include <string_view>
#include <vector>

#include "bench/kit/problem.h"
#include "cases/generators/cases.h"

namespace desmo::size {

enum class Question {
  growth,      ///< how does time grow with the number of coordinates?
  break_even,  ///< with how many unknowns cost dense and sparse matrices the same, all at once?
};
std::string_view name_of(Question question);

/// Formulations that solve the same problem and are timed in turn.
struct SizeSeries {
  Question question;
  const Case* definition;
  int size;  ///< number of coordinates (growth) or of unknowns (break_even)
  std::vector<std::string_view> ids;

  /// Makes the problem: its model, its time grid and the tolerance.
  bench::Problem problem() const;
};

/// Returns the series of both cases: of growth with 114 to 99,903 coordinates, of break_even with
/// about 10 to 500 unknowns; in a quick run up to 336 coordinates, and about 100 unknowns.
///
/// filter: found in <growth|break_even>/<case>/<size>/<id> of each formulation returned; series
/// without any are left out.
std::vector<SizeSeries> make_series(bool quick = false, const std::regex& filter = std::regex(""));

/// Returns the smallest part of a mechanism that has at least `min_unknowns` unknowns and can be
/// solved alone: the part that its first entities need. Returns the whole where it has fewer
/// unknowns.
Model smallest_part(const Model& whole, int min_unknowns);

}  // namespace desmo::size
