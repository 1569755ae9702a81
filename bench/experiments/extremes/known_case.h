#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/extremes/extremes.h"
#include "formulations/base/per_level.h"
#include "formulations/base/reference_instant.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/modelling.h"

namespace desmo::extremes {

/// The right answers for a part of a mechanism, or for all of it. Errors are relative to the size
/// and the motion of the part.
struct Answers {
  Model model;                       ///< model of the part alone
  std::vector<int> coordinate = {};  ///< by coordinate of the part: its index in the whole model
  /// One for each compared instant or start; empty q: no answer is known.
  std::vector<ReferenceInstant> right = {};
  std::vector<PerLevel<double>> floor = {};  ///< one for each answer: error by conditioning
  Scales scales = {};                        ///< scales by which errors are divided
  double condition = 0;                      ///< largest condition number of the answers
  double chain_length = 0;  ///< links × longest link, divided by the size; 0: no chain
};

/// A case of an extreme with what is known of it.
struct KnownCase {
  const ExtremeCase* definition;
  std::optional<ModellingResult> modelled = {};  ///< nothing: modelling refused the mechanism
  std::string refusal = {};                      ///< why it was refused
  std::string no_answer = {};  ///< why nothing is known to compare with; then answers is empty
  std::vector<Answers> answers = {};
  std::vector<int> compared = {};   ///< indices of compared instants, or starts, ascending
  std::vector<bool> solvable = {};  ///< by instant of the grid, or start: it has an answer
  std::vector<double> ends = {};    ///< times at which chains' answers end or begin [s]
  std::vector<std::vector<double>> starts = {};  ///< initial estimates; empty: a motion is solved

  /// Returns the largest condition number of all answers; 0: not known.
  double condition() const;
};

/// Returns a case with its answers. The definition must outlive it.
KnownCase make_known_case(const ExtremeCase& definition);

}  // namespace desmo::extremes
