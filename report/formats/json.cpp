// Written by hand, so that 7.100 stays 7.100: a JSON library would print 7.1.
#include <nlohmann/json.hpp>

#include "report/formats/formats.h"

namespace desmo::report {
namespace {

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

// "[a, b]", or one item a line, indented.
std::string array(const std::vector<std::string>& items, const std::string& indent) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ",") + ("\n" + indent + item);
  return "[" + text + "]";
}

std::string entry_json(const Column& column, const Entry& entry) {
  if (column.quantities.empty()) return quoted(entry.shown);
  std::string text;
  for (std::size_t i = 0; i < column.quantities.size(); ++i) {
    const std::string digits = i < entry.digits.size() ? entry.digits[i] : "";
    text += quoted(column.quantities[i]) + ": " + (digits.empty() ? "null" : digits) + ", ";
  }
  if (entry.note.empty())
    text.resize(text.size() - 2);
  else
    text += "\"note\": " + quoted(entry.note);
  return "{" + text + "}";
}

std::string table_json(const Table& table) {
  std::vector<std::string> notes, columns, rows;
  for (const std::string& note : table.notes) notes.push_back(quoted(note));
  for (const Column& column : table.columns) columns.push_back(quoted(column.name));
  for (const auto& row : table.rows) {
    std::string text;
    for (std::size_t i = 0; i < row.size(); ++i)
      text += (i == 0 ? "" : ", ") + columns[i] + ": " + entry_json(table.columns[i], row[i]);
    rows.push_back("{" + text + "}");
  }
  return "{\"name\": " + quoted(table.name) + ",\n      \"title\": " + quoted(table.title) +
         ",\n      \"notes\": " + array(notes, "        ") +
         ",\n      \"columns\": " + array(columns, "        ") +
         ",\n      \"rows\": " + array(rows, "        ") + "}";
}

}  // namespace

std::string to_json(const Document& document) {
  std::vector<std::string> sections;
  for (const Section& section : document.sections) {
    std::vector<std::string> paragraphs, tables;
    for (const std::string& paragraph : section.paragraphs) paragraphs.push_back(quoted(paragraph));
    for (const Table& table : section.tables) tables.push_back(table_json(table));
    sections.push_back("{\"title\": " + quoted(section.title) +
                       ",\n    \"paragraphs\": " + array(paragraphs, "      ") +
                       ",\n    \"tables\": " + array(tables, "     ") + "}");
  }
  return "{\"schema\": \"desmo-tables\",\n \"version\": \"1.0.0\",\n \"title\": " +
         quoted(document.title) + ",\n \"sections\": " + array(sections, "   ") + "}\n";
}

}  // namespace desmo::report
