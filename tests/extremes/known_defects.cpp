#include "tests/extremes/known_defects.h"

#include <algorithm>
#include <array>

namespace desmo::extreme {

std::span<const KnownDefect> known_defects() {
  using enum Verdict;
  static const std::array all{
      KnownDefect{1, "1 dyads, equal", defect},
      KnownDefect{1, "10 dyads, equal", defect},
      KnownDefect{1, "1000 dyads, equal", missed},
      KnownDefect{1, "10 dyads, unequal", defect},
      KnownDefect{1, "1000 dyads, unequal", missed},
      KnownDefect{2, "slack 1e-02, within 1e-01 rad", defect},
      KnownDefect{2, "slack 1e-02, within 1e-05 rad", defect},
      KnownDefect{2, "slack 1e-06, within 1e-01 rad", defect},
      KnownDefect{2, "slack 1e-06, within 1e-03 rad", defect},
      KnownDefect{2, "slack 1e-06, within 1e-05 rad", defect},
      KnownDefect{2, "slack 1e-12, within 1e-01 rad", defect},
      KnownDefect{2, "slack 1e-12, within 1e-03 rad", defect},
      KnownDefect{2, "slack 1e-12, within 1e-05 rad", defect},
      KnownDefect{3, "dead point", defect},
      KnownDefect{3, "parallel cranks in line", defect},
      KnownDefect{3, "8 parallel cranks in line", defect},
      KnownDefect{4, "the same, until it has reopened", defect},
      KnownDefect{4, "the same, the instant to 1e-9 s", missed},
      KnownDefect{5, "four-bar of 3 dyads, steps of 3 rad", defect},
      KnownDefect{5, "Andrews' mechanism, steps of 3 rad", defect},
      KnownDefect{5, "folding rhombus, steps of 0.05 s", defect},
      KnownDefect{5, "folding rhombus, steps of 0.5 s", defect},
      KnownDefect{5, "four-bar of 2 dyads, from anywhere", defect},
      KnownDefect{7, "× 1e-9 and × 1e9 in one", missed},
      KnownDefect{7, "× 1e-150", missed},
      KnownDefect{7, "× 1e+150", missed},
      KnownDefect{9, "four-bar of 1 dyads, 50 % off", defect},
      KnownDefect{9, "four-bar of 1 dyads, 200 % off", defect},
      KnownDefect{9, "four-bar of 3 dyads, 50 % off", defect},
      KnownDefect{9, "four-bar of 3 dyads, 200 % off", defect},
      KnownDefect{9, "andrews, 10 % off", defect},
      KnownDefect{11, "a revolution/jacobian:step", defect},
      KnownDefect{11, "a revolution/jacobian:chord", defect},
      KnownDefect{12, "RSSR, its idle freedom named", missed},
      KnownDefect{13, "1e-16", missed},
  };
  return all;
}

const KnownDefect* find_known_defect(int row, std::string_view case_name) {
  const auto all = known_defects();
  const auto it = std::ranges::find_if(all, [&](const KnownDefect& known) {
    return known.row == row && known.case_name == case_name;
  });
  return it == all.end() ? nullptr : &*it;
}

}  // namespace desmo::extreme
