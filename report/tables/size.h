// The parts of the report about time against size, and about instructions: pure functions of the
// record.
#pragma once

#include <string>
#include <vector>

#include "report/read/record.h"
#include "report/statistics/curves.h"
#include "report/tables/slope.h"
#include "report/text/document.h"

namespace desmo::report {

/// Is growth linear, up to where, and what is in which cache by then. The record has `growth`.
Section growth(const Record& record);

/// The data of the figure of growth: a row for each case, formulation and size.
Table growth_data(const Record& record);

/// The log-log slope of every curve of growth, up to where a coordinate costs much the same, and
/// what it costs while memory is held by each cache.
Table growth_exponents(const std::vector<Curve>& curves);
Table growth_caches(const Record& record, const std::vector<Curve>& curves);

/// The times by which growth is judged: those up to max_linear_coordinates.
SizedTimes fitted_times(const Curve& curve);

/// Where solving all of a mechanism at once costs the same with dense and with sparse matrices.
/// The record has `crossing`.
Section dense_or_sparse(const Record& record);

/// Its data: µs a step of every formulation, by unknowns.
Table break_even_times(const Record& record, const std::string& case_name);

/// Instructions of a step, and how many times those of the usual reference. The record has
/// `instructions`.
Section instructions(const Record& record);

}  // namespace desmo::report
