#include "tests/extremes/known_defects.h"

#include <algorithm>
#include <array>

namespace desmo::extreme {

std::span<const KnownDefect> known_defects() {
  using enum Verdict;
  static const std::array all{
      KnownDefect{1, "K = 1000, unequal", missed},
      KnownDefect{2, "slack 1e-12, within 1e-01 rad", missed},
      KnownDefect{3, "dead point", defect},
      KnownDefect{3, "parallel cranks in line", defect},
      KnownDefect{4, "the same, the instant to 1e-9 s", missed},
      KnownDefect{5, "Andrews' mechanism, steps of 3 rad", defect},
      KnownDefect{5, "folding rhombus, steps of 0.05 s", defect},
      KnownDefect{5, "folding rhombus, steps of 0.5 s", defect},
      KnownDefect{5, "four-bar, K = 2, from anywhere", defect},
      KnownDefect{7, "× 1e-9 and × 1e9 in one", missed},
      KnownDefect{7, "× 1e-150", missed},
      KnownDefect{7, "× 1e+150", missed},
      KnownDefect{9, "four-bar, K = 1, 50 % off", defect},
      KnownDefect{9, "four-bar, K = 1, 200 % off", defect},
      KnownDefect{9, "four-bar, K = 3, 50 % off", defect},
      KnownDefect{9, "four-bar, K = 3, 200 % off", defect},
      KnownDefect{9, "andrews, 10 % off", defect},
      KnownDefect{10, "a driver infinite after 1 s", missed},
      KnownDefect{11, "a revolution/jacobian:step", defect},
      KnownDefect{11, "a revolution/jacobian:chord", defect},
      KnownDefect{12, "RSSR, its idle freedom named", missed},
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
