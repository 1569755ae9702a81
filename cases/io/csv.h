// Lines of tables of numbers, as people and programs write them.
#pragma once

#include <string_view>
#include <vector>

namespace desmo {

/// Splits a line at commas or tabs where there are any, and else at blanks. Fields lose the blanks
/// around them. Semicolons are not taken: next to them commas may be decimal ones.
void split_fields(std::string_view line, std::vector<std::string_view>& fields);

/// Returns a text without the blanks around it.
std::string_view trimmed(std::string_view text);

/// Returns the text of a file without the byte order mark that some programs begin it with.
std::string_view without_mark(std::string_view text);

/// Reads a whole field as a number. Returns whether it is one.
bool to_number(std::string_view field, double& value);

/// Name and unit of a column: those of `theta [deg]` or `theta (deg)`, also in quotes.
struct ColumnHeading {
  std::string_view name, unit;  ///< the unit may be empty
  bool has_unit;
};
ColumnHeading column_heading(std::string_view field);

}  // namespace desmo
