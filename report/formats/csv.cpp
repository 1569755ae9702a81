// CSV, for spreadsheets and programs: a heading and the rows of one table, and nothing else.
#include "report/formats/formats.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  return "\"" + escaped(text, {{'"', "\"\""}}) + "\"";
}

/// Returns a text that no spreadsheet takes for a formula: one that would be begins with an
/// apostrophe.
std::string text_field(const std::string& text) {
  const bool begins_one = text.find_first_of("=+-@\t\r") == 0;
  return begins_one && !read_number(text) ? "'" + text : text;
}

std::string line(const std::vector<std::string>& fields) {
  std::string text;
  for (std::size_t i = 0; i < fields.size(); ++i) text += (i == 0 ? "" : ",") + field(fields[i]);
  return text + "\n";
}

}  // namespace

std::string to_csv(const Table& table) {
  std::vector<std::string> names;
  bool numbers = false;
  for (const Column& column : table.columns) {
    if (column.quantities.empty()) names.push_back(column.name);
    for (const std::string& quantity : column.quantities)
      names.push_back(column.name + " " + quantity);
    numbers = numbers || !column.quantities.empty();
  }
  if (numbers) names.push_back("notes");
  std::string text = line(names);

  for (const auto& row : table.rows) {
    std::vector<std::string> fields;
    std::string notes;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Column& column = table.columns[i];
      const Entry& entry = row[i];
      if (column.quantities.empty()) {
        fields.push_back(text_field(entry.shown));
        continue;
      }
      std::vector<std::string> digits = entry.digits;
      digits.resize(column.quantities.size());
      if (!entry.has_number())
        digits.front() = text_field(entry.note);
      else if (!entry.note.empty())
        notes += (notes.empty() ? "" : "; ") + column.name + ": " + entry.note;
      fields.insert(fields.end(), digits.begin(), digits.end());
    }
    if (numbers) fields.push_back(text_field(notes));
    text += line(fields);
  }
  return text;
}

}  // namespace desmo::report
