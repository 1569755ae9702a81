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

/// The right answers for a part of a mechanism whose errors are relative to its own size.
struct Answers {
  Model model;                       ///< of the part alone
  std::vector<int> coordinate = {};  ///< in the whole, of each of the part
  std::vector<ReferenceInstant> right =
      {};  ///< one for each instant compared; no q where there is none
  std::vector<PerLevel<double>> floor = {};  ///< one for each answer
  Scales scales = {};
  double condition = 0;     ///< the largest of those compared
  double chain_length = 0;  ///< links × longest link, over the size; 0: no chain
};

/// A case of an extreme with what is known of it.
struct KnownCase {
  const ExtremeCase* definition;
  std::optional<ModellingResult> modelled = {};  ///< nothing: refused
  std::string refusal = {};
  std::string no_answer = {};  ///< why nothing is known to compare with; then answers is empty
  std::vector<Answers> answers = {};
  std::vector<int> compared = {};   ///< instants of the grid, or starts, ascending
  std::vector<bool> solvable = {};  ///< each instant of the grid, or start
  std::vector<double> ends = {};    ///< times between them at which answers end or begin
  std::vector<std::vector<double>> starts = {};  ///< estimates, where it is solved from them

  /// Returns the largest condition number of what is compared; 0: not known.
  double condition() const;
};

/// Returns a case with its answers. The definition must outlive it.
KnownCase make_known_case(const ExtremeCase& definition);

}  // namespace desmo::extremes
