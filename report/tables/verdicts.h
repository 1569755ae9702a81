// What the numbers say about the paper's conclusions, one sparse family at a time. A comparison
// counts when the interval of the mean speed-up excludes 1.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/record.h"
#include "report/statistics.h"

namespace desmo::report {

/// What the paper concludes: in each pair of variants (by position in `variants`), the second is
/// the faster.
struct Claim {
  std::string text;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

const std::vector<Claim>& claims();

/// One family over the sizes at which it can be judged.
struct Family {
  std::string name;
  std::vector<std::int64_t> sizes;   ///< of the paper's, all five truck variants measured
  std::vector<std::size_t> ranking;  ///< fastest first; empty when there is no such size
  std::map<std::size_t, SpeedUp> over_global;
};

/// Every recorded family, in its order.
std::vector<Family> judged_families(const Record& record);

/// The four topological variants by the paper's mean speed-up, fastest first.
std::vector<std::size_t> paper_ranking();

/// "holds", "is reversed", "holds except for ..."; "cannot be said" of a family without sizes.
std::string verdict(const Record& record, const Family& family, const Claim& claim);
std::string ranking_verdict(const Record& record, const Family& family);

/// Whether the verdicts on the claims depend on the solver, and whether they are the paper's;
/// families that cannot be judged have no say.
enum class Agreement { nothing_judged, depends_on_solver, as_the_paper, not_as_the_paper };
Agreement agreement(const Record& record, const std::vector<Family>& families);

/// What the paper's own solver says of its conclusion, where it was recorded and can be judged, and
/// which of its stand-ins say the same; else empty.
std::string papers_own_verdict(const Record& record, const std::vector<Family>& families);

/// "a, b and c"
std::string enumeration(const std::vector<std::string>& items);

/// The mean speed-up of the paper's fastest variant: "0.75 with cholmod and 2.37 with umfpack", or
/// with `unit` after each number; the paper's own solver is called that. Empty when no family can
/// be judged.
std::string best_by_family(const std::vector<Family>& families, const std::string& unit = "");

}  // namespace desmo::report
