#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/generators/dyad_chain.h"
#include "cases/mechanism/scene.h"

namespace desmo {

/// How wrong an answer of an extreme may be. The floor is what conditioning lets double precision
/// reach at that level, the rounding of the drivers included.
enum class Bound {
  floor,       ///< factor × floor
  length,      ///< position: factor × ε × links × longest link, and the floor; else the floor
  tolerance,   ///< factor × the larger of tolerance and floor
  first_case,  ///< factor × the error of the row's first case, or the floor; iterations ±1 a step
  first_part,  ///< after the first half of what is compared: factor × its error, or the floor
  new_pivots,  ///< factor × the error with factors made anew at each position, or the floor
  fixed,       ///< position: factor, relative to the mechanism's size; else the floor
  estimates,   ///< what is said of the instant; that, factor × what tolerance or floor allow
};

/// One mechanism and motion of an extreme, and what is expected of every formulation: answers
/// within the bound wherever there is one, a flag wherever there is none.
struct ExtremeCase {
  std::string name;  ///< unique in its row
  Scene scene;
  /// Where the mechanism consists of them, and of nothing else, a closed form gives the answers.
  std::vector<DyadChain> chains = {};
  Bound bound = Bound::tolerance;
  double factor = 10;
  /// Settings as suffixes of an id (formulations/id.h): "/jacobian:step".
  std::string settings = {};

  /// Instants, at the beginning and, as many again, at the end, that are compared; 0: 201 or fewer,
  /// spread over all.
  int compared_at_ends = 0;
  /// The last instant is singular, which a mechanism without a closed form has to be told.
  bool ends_singular = false;

  bool may_fail = false;       ///< a flag is as good as an answer
  bool goes_on = false;        ///< past what cannot be solved, both its ends to 1e-9 s
  bool is_refused = false;     ///< before anything is solved, or at the first instant
  bool is_redundant = false;   ///< what follows from other equations has to be reported
  std::string failing_body{};  ///< in the group that is to be named where it fails
  std::string idle_body{};     ///< whose freedom to spin is to be reported

  /// Solved from estimates that are off by up to so much of natural magnitudes, instead of in
  /// steps: the branch is that on whose side the estimate is.
  struct Starts {
    int count;
    double off;
  };
  std::optional<Starts> starts = {};
};

/// How much of an extreme: what takes seconds, or everything.
enum class Extent { brief, full };

/// A row of the table of extremes.
struct Extreme {
  int number;
  std::string_view name;
  std::string_view extreme, expected;  ///< for people
  std::vector<ExtremeCase> (*cases)(Extent extent);
};

/// Every extreme, by number. Tests, the bench and documents iterate this table.
std::span<const Extreme> all_extremes();

/// Of that number. Throws std::invalid_argument when there is none.
const Extreme& find_extreme(int number);

}  // namespace desmo
