// Lines of tables of numbers, as people and programs write them.
#pragma once

#include <string_view>
#include <vector>

namespace desmo {

/// Splits a line into `fields`: at commas and tabs where there are any, otherwise at blanks. Fields
/// are trimmed(). Semicolons do not separate, since in files that have them commas may be decimal
/// ones.
void split_fields(std::string_view line, std::vector<std::string_view>& fields);

/// Returns a text without the blanks, tabs and carriage returns around it.
std::string_view trimmed(std::string_view text);

/// Returns the text of a file without the byte order mark of UTF-8, if it begins with one.
std::string_view without_mark(std::string_view text);

/// Reads a whole field as a number, which may have a plus sign. Returns whether it is one; "inf"
/// and "nan" are, too.
bool to_number(std::string_view field, double& value);

/// Name and unit of a column, read from `theta [deg]` or `theta (deg)`, also in quotes.
struct ColumnHeading {
  std::string_view name, unit;  ///< the unit is empty where there are no brackets, or empty ones
  bool has_unit;                ///< the heading has brackets
};
ColumnHeading column_heading(std::string_view field);

}  // namespace desmo
