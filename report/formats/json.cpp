// JSON, for programs: the whole report, with numbers as JSON numbers.
#include <nlohmann/json.hpp>

#include "report/formats/formats.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

using Json = nlohmann::ordered_json;

Json number(const std::string& digits) {
  return digits.empty() ? Json() : Json::parse(without_plus(digits));
}

Json json_of(const Column& column, const Entry& entry) {
  if (column.quantities.empty())
    return entry.has_number() ? number(entry.digits.front()) : Json(entry.shown);
  Json value = Json::object();
  for (std::size_t i = 0; i < column.quantities.size(); ++i)
    value[column.quantities[i]] = number(i < entry.digits.size() ? entry.digits[i] : "");
  if (!entry.note.empty()) value["note"] = entry.note;
  return value;
}

Json json_of(const Table& table) {
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json named = Json::object();
    for (std::size_t i = 0; i < row.size(); ++i)
      named[table.columns[i].name] = json_of(table.columns[i], row[i]);
    rows.push_back(std::move(named));
  }
  return {{"name", table.name}, {"title", table.title}, {"notes", table.notes}, {"rows", rows}};
}

}  // namespace

std::string to_json(const Document& document) {
  Json sections = Json::array();
  for (const Section& section : document.sections) {
    Json tables = Json::array();
    for (const Table& table : section.tables) tables.push_back(json_of(table));
    sections.push_back({{"chapter", section.chapter},
                        {"title", section.title},
                        {"paragraphs", section.paragraphs},
                        {"definitions", section.definitions},
                        {"tables", tables}});
  }
  const Json all{{"title", document.title}, {"sections", sections}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace desmo::report
