#include "cases/io/csv.h"

#include "cases/mechanism/formatted.h"

namespace desmo {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

void split_fields(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  line = trimmed(line);
  const bool at_blanks = line.find_first_of(",\t") == std::string_view::npos;
  while (true) {
    const std::size_t end = line.find_first_of(at_blanks ? " " : ",\t");
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
    if (at_blanks) line = trimmed(line);
  }
}

std::string_view without_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  return text;
}

bool to_number(std::string_view field, double& value) {
  if (field.starts_with('+') && !field.starts_with("+-")) field.remove_prefix(1);
  return parse_number(field, value);
}

ColumnHeading column_heading(std::string_view field) {
  if (field.size() > 1 && field.front() == '"' && field.back() == '"')
    field = field.substr(1, field.size() - 2);
  const std::size_t bracket = field.ends_with(']')   ? field.rfind('[')
                              : field.ends_with(')') ? field.rfind('(')
                                                     : std::string_view::npos;
  if (bracket == std::string_view::npos) return {field, {}, false};
  return {trimmed(field.substr(0, bracket)),
          trimmed(field.substr(bracket + 1, field.size() - bracket - 2)), true};
}

}  // namespace desmo
