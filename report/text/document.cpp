#include "report/text/document.h"

#include <algorithm>
#include <utility>

namespace desmo::report {

Entry composed(std::string_view form, std::vector<std::string> digits, std::string note) {
  std::string shown(form);
  for (const std::string& number : digits)
    if (const std::size_t at = shown.find("{}"); at != shown.npos && !number.empty())
      shown.replace(at, 2, number);
  if (!note.empty()) shown += " " + note;
  return {std::move(shown), std::move(digits), std::move(note)};
}

// A text in place of a number has no `digits`; a verdict has some, which may all be "". A reference
// is no mark: designs draw it as a line, or not at all.
bool Table::has_marks() const {
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      if (!columns[i].quantities.empty() && (drawn.empty() || columns[i].name == drawn) &&
          !row[i].digits.empty() && row[i].note != "reference")
        return true;
  return false;
}

void Document::add(Section section) {
  std::erase_if(section.tables, [](const Table& table) { return table.rows.empty(); });
  for (Table& table : section.tables)
    if (!table.has_marks()) table.figure.clear();
  if (!section.tables.empty() || !section.paragraphs.empty())
    sections.push_back(std::move(section));
}

}  // namespace desmo::report
