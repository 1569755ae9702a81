// Texts for people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "formulations/model/model.h"

namespace desmo::cli {

/// Returns "1 body", "2 bodies"; plural: by default the noun with an s.
std::string count(long n, const std::string& noun, const std::string& plural = "");

/// Returns "a, b, c"; for more than `most` names "a, b, c, … (7 more)".
std::string enumerate(const std::vector<std::string>& names, std::size_t most = 1000000);

/// Returns the names of the entities, groups or constraints at these positions.
template <class Named>
std::vector<std::string> names_at(const std::vector<Named>& all,
                                  const std::vector<int>& positions) {
  std::vector<std::string> names;
  for (const int p : positions) names.push_back(all[p].name);
  return names;
}

/// Returns "group 'SG-II' (rod, slider)", naming at most eight of its bodies.
std::string named_group(const Group& group);

/// Returns "group 'SG-II' (rod, slider), ", with which notes begin; "" for no group, -1.
std::string in_group(GroupId group, const Model& model);

/// Returns "t = 0.3 s". time: [s]
std::string time_text(double time);

/// Returns "t = 1 s to 2 s"; "t = 1 s" where both times are the same in print.
std::string time_range_text(double from, double to);

/// Returns the names of the driven coordinates.
std::vector<std::string> driver_names(const Model& model);

/// Breaks a text into lines of at most 100 − indent characters, longer words excepted. Indents all
/// lines but the first, before which the caller may have written up to `indent` characters.
std::string wrap(const std::string& text, std::size_t indent);

/// Returns a table: two blanks before each column, none at the ends of lines.
/// - right: character c is 'r' where column c is aligned to the right
std::string table(const std::vector<std::vector<std::string>>& rows, std::string_view right);

}  // namespace desmo::cli
