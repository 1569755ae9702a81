#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/generators/dyad_chain.h"
#include "cases/mechanism/scene.h"

namespace desmo {

/// Bound on the error of an extreme's answers. The *floor* is the error that conditioning and the
/// rounding of the drivers allow in double precision at a level.
enum class Bound {
  floor,       ///< factor × floor
  length,      ///< position: factor × ε × links × longest link + 10 × floor; else 10 × floor
  tolerance,   ///< factor × max(tolerance, floor)
  first_case,  ///< factor × error of the row's first case, or floor; iterations ±1 a step
  first_part,  ///< factor × error of the first half of the compared instants, or floor
  new_pivots,  ///< factor × error with a new factorisation at each position, or floor
  fixed,       ///< position: factor, relative to the mechanism's size; else 10 × floor
  estimates,   ///< the stated bound, itself at most factor × that of tolerance or floor
};

/// A mechanism and a motion of an extreme, and what is expected of every formulation. It must give
/// an answer within the bound where one exists, and a flag where none does.
struct ExtremeCase {
  std::string name;  ///< unique within the row
  Scene scene;
  /// Chains that the mechanism consists of, if nothing else: a closed form then gives the answers.
  std::vector<DyadChain> chains = {};
  Bound bound = Bound::tolerance;
  double factor = 10;
  /// Settings as suffixes of an id (formulations/id.h), for instance "/jacobian:step".
  std::string settings = {};

  /// Number of instants compared at the beginning, and as many at the end. 0: 201 or fewer, spread
  /// over all.
  int compared_at_ends = 0;
  /// Singularity of the last instant, which a mechanism without a closed form has to state.
  bool ends_singular = false;

  bool may_fail = false;       ///< a flag is as good as an answer
  bool past_failures = false;  ///< the run continues after a gap, whose ends it finds to 1e-9 s
  bool is_refused = false;     ///< it is rejected before solving, or at the first instant
  bool is_redundant = false;   ///< dependent equations must be reported
  std::string failing_body{};  ///< body in the group that a failure must name
  std::string idle_body{};     ///< body whose freedom to spin must be reported

  /// Assemblies from random initial estimates instead of a motion. An estimate is off by up to
  /// `off` times the nominal magnitudes, and determines the branch.
  struct Starts {
    int count;
    double off;
  };
  std::optional<Starts> starts = {};
};

/// Number of cases of an extreme to make: those that take seconds, or all.
enum class Extent { brief, full };

/// Row of the table of extremes.
struct Extreme {
  int number;
  std::string_view name;
  std::string_view extreme, expected;  ///< texts for people
  std::vector<ExtremeCase> (*cases)(Extent extent);
};

/// Returns every extreme, by number. Tests, the bench and documents iterate this table.
std::span<const Extreme> all_extremes();

/// Returns the extreme of that number. Throws std::invalid_argument when there is none.
const Extreme& find_extreme(int number);

}  // namespace desmo
