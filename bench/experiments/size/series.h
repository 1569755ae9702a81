#pragma once

#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "bench/experiments/size/problem.h"
#include "cases/generators/cases.h"

namespace desmo::size {

/// What is measured: how time grows with the number of coordinates, and where it costs the same to
/// solve all unknowns at once with dense and with sparse matrices.
enum class Question { growth, break_even };
std::string_view name_of(Question question);

/// Formulations that solve the same problem and are timed in turn.
struct Series {
  Question question;
  const Case* definition;
  int size;  ///< coordinates of growth; unknowns of break_even
  std::vector<std::string_view> ids;

  Problem problem() const;
};

/// Both cases from the smallest of the paper's sizes to a hundred thousand coordinates, and with 10
/// to 500 unknowns.
std::vector<Series> all_series();

/// Up to 336 coordinates and 100 unknowns.
std::vector<Series> quick_series();

/// What is left of them when only formulations are kept in whose
/// <growth|break_even>/<case>/<size>/<id> the expression is found; series with none are left out.
std::vector<Series> matching(std::vector<Series> all, const std::regex& expression);

}  // namespace desmo::size
