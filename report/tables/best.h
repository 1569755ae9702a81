// The best formulations of one thread, held against the global reference like for like.
#pragma once

#include <optional>

#include "report/read/record.h"
#include "report/statistics/measurements.h"
#include "report/text/document.h"

namespace desmo::report {

/// The things that a formulation solves side by side.
enum class Batch { none, lanes, segments };

/// A formulation at the truck's largest size, and how many times as fast it is as the fastest
/// global_automatic_<sparse> with the same guess and tolerance, and with the paper's settings.
struct Best {
  CandidateKey key;
  MeasuredSpeedUp like_for_like;
  MeasuredSpeedUp papers_settings;
};

/// Finds the fastest formulation by groups or blocks with the guess and the tolerance of the
/// fastest global reference.
std::optional<Best> best_generated(const Record& record, Batch batch);

/// Lists the references and the best formulations with the paper's settings and with the best.
Table best_formulations(const Record& record);

}  // namespace desmo::report
