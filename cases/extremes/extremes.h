#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/generators/dyad_chain.h"
#include "cases/mechanism/scene.h"

namespace desmo {

/// Bound on the errors of a case's answers, all of them relative. The *floor* of a level (position,
/// velocity, acceleration) is the error in double precision that conditioning and the rounding of
/// the drivers explain. `factor` is ExtremeCase::factor, and ε is 2^-52.
enum class Bound {
  floor,  ///< factor × floor
  length,  ///< position: factor × ε × dyads × longest link / size + 10 × floor; else 10 × floor
  tolerance,   ///< factor × max(tolerance, floor)
  first_case,  ///< max(factor × largest error of the row's first case, floor); iterations of each
               ///< step within ±1 of that case's
  first_part,  ///< 10 × max(tolerance, floor) in the first half of the compared instants; then
               ///< max(factor × largest error of that half, floor)
  new_pivots,  ///< max(factor × largest error with a new factorisation at each position, floor)
  fixed,       ///< position: factor, relative to the mechanism's size; else 10 × floor
  estimates,   ///< the radius stated with each instant; the largest stated position radius is at
               ///< most factor × max(tolerance, condition number × 2^-53), and grows by the
               ///< condition number from level to level
};

/// A mechanism and a motion at an extreme, and the answers expected of every formulation. It must
/// deliver numbers within the bound where an answer exists, and a flag where none does. A *flag*
/// marks an instant as failed, not proven, or on another branch.
struct ExtremeCase {
  std::string name;  ///< unique within the row
  Scene scene;
  /// Dyad chains, where the mechanism consists of these alone: a closed form then gives the
  /// answers.
  std::vector<DyadChain> chains = {};
  Bound bound = Bound::tolerance;
  double factor = 10;  ///< factor in the bound
  /// Settings as suffixes of an id (formulations/id.h), for instance "/jacobian:step".
  std::string settings = {};

  /// Number of instants that are compared at the beginning, and as many at the end. 0: at most 201
  /// instants, spread over the motion; with `starts`, every start.
  int compared_at_ends = 0;
  /// The last instant is singular and has no answer. With `chains`, the closed form tells that.
  bool ends_singular = false;

  bool may_fail = false;  ///< a flag is accepted where an answer exists, too
  /// The run goes on after instants without an answer. It must state the times at which answers end
  /// and begin again, right to 1e-9 s.
  bool past_failures = false;
  bool is_refused = false;     ///< it must be rejected before solving, or fail at the first instant
  bool is_redundant = false;   ///< dependent equations must be reported
  std::string failing_body{};  ///< a failure must name the group of this body; empty: no demand
  std::string idle_body{};     ///< freedom of this body to spin must be reported; empty: no demand

  /// Assemblies from random initial estimates instead of a motion. Each estimate determines the
  /// branch of its answer.
  struct Starts {
    int count;   ///< number of estimates
    double off;  ///< largest error of an undriven coordinate's estimate, divided by its nominal
                 ///< magnitude
  };
  std::optional<Starts> starts = {};
};

/// Cases of an extreme to make: a selection that takes seconds (brief), or all (full).
enum class Extent { brief, full };

/// A row of the table of extremes.
struct Extreme {
  int number;
  std::string_view name;
  std::string_view extreme, expected;  ///< texts for people: the difficulty, the expected answer
  std::vector<ExtremeCase> (*cases)(Extent extent);
};

/// Returns every extreme, by number. Tests, the bench and documents iterate this table.
std::span<const Extreme> all_extremes();

/// Returns the extreme of that number. Throws std::invalid_argument when there is none.
const Extreme& find_extreme(int number);

}  // namespace desmo
