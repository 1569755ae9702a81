#include "tests/extremes/known_defects.h"

#include <algorithm>
#include <array>

namespace desmo::extremes {

std::span<const KnownDefect> known_defects() {
  static const std::array<KnownDefect, 0> all{};
  return all;
}

const KnownDefect* find_known_defect(int row, std::string_view case_name) {
  const auto all = known_defects();
  const auto it = std::ranges::find_if(all, [&](const KnownDefect& known) {
    return known.row == row && known.case_name == case_name;
  });
  return it == all.end() ? nullptr : &*it;
}

}  // namespace desmo::extremes
