#include "report/figures/figures.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "report/text/digits.h"
#include "report/text/embedded.h"

namespace desmo::report {
namespace {

using Json = nlohmann::ordered_json;

/// Adds the numbers of an entry to a datum, with the digits that are printed. A missing first
/// quantity is null; other missing ones are left out.
/// - is_folded: the design has `fold` (figures.h), so that keys do not begin with the column's name
void add_numbers(Json& datum, const Column& column, const Entry& entry, bool is_folded) {
  for (std::size_t i = 0; i < column.quantities.size(); ++i) {
    const bool known = i < entry.digits.size() && !entry.digits[i].empty();
    if (!known && i > 0) continue;
    const std::string& quantity = column.quantities[i];
    datum[is_folded ? quantity
          : i == 0  ? column.name
                    : column.name + " " + quantity] =
        known ? Json::parse(without_plus(entry.digits[i])) : Json();
  }
  const std::string of = is_folded ? "" : column.name + " ";
  datum[of + "shown"] = entry.shown;
  if (!entry.note.empty()) datum[of + "note"] = entry.note;
}

Json data_of(const Table& table, const std::string& fold) {
  Json data = Json::array();
  for (const auto& row : table.rows) {
    Json datum;
    for (std::size_t i = 0; i < row.size(); ++i)
      if (table.columns[i].quantities.empty()) datum[table.columns[i].name] = row[i].shown;
    const Json texts = datum;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (table.columns[i].quantities.empty()) continue;
      if (!fold.empty()) datum = texts;
      add_numbers(datum, table.columns[i], row[i], !fold.empty());
      if (fold.empty()) continue;
      datum[fold] = table.columns[i].name;
      data.push_back(datum);
    }
    if (fold.empty()) data.push_back(std::move(datum));
  }
  return data;
}

std::set<std::string> values_of(const Json& data, const std::string& field) {
  std::set<std::string> values;
  for (const Json& datum : data)
    if (const auto value = datum.find(field); value != datum.end() && value->is_string())
      values.insert(value->get<std::string>());
  return values;
}

/// Leaves in a scale the names of its domain that were measured, each with its element of the
/// range. Adds measured names that are not in the domain.
void keep_measured(Json& scale, const std::string& channel, std::set<std::string> measured) {
  Json names = Json::array(), range = Json::array();
  for (std::size_t i = 0; i < scale["domain"].size(); ++i)
    if (measured.erase(scale["domain"][i].get<std::string>())) {
      names.push_back(scale["domain"][i]);
      range.push_back(scale["range"][i]);
    }
  for (const std::string& name : measured) {
    names.push_back(name);
    range.push_back(channel == "color"   ? Json("#888888")
                    : channel == "shape" ? Json("cross")
                                         : scale["range"].back());
  }
  scale["domain"] = std::move(names);
  scale["range"] = std::move(range);
}

/// Leaves the measured names in all scales that have a range, below a node of a specification. A
/// scale with a named range takes all measured names as its domain. A scale of a field without data
/// stays as it is.
/// - domains: domains that the design states, by field. Only a field's first scale must state one
/// - shown: if it is null, it becomes the domain of the first scale with a range
void keep_measured(Json& node, const Json& data, std::map<std::string, Json>& domains,
                   Json& shown) {
  for (auto& [channel, child] : node.items()) {
    if (child.is_object() && child.contains("field") && child.contains("scale")) {
      Json& scale = child["scale"];
      const std::string field = child["field"];
      const auto measured = values_of(data, field);
      const bool has_range = scale.contains("range");
      if (has_range && scale["range"].is_string()) {
        scale["domain"] = measured;
      } else if (has_range) {
        if (!scale.contains("domain")) scale["domain"] = domains.at(field);
        domains.emplace(field, scale["domain"]);
        if (!measured.empty()) keep_measured(scale, channel, measured);
      }
      if (shown.is_null() && has_range) shown = scale["domain"];
    }
    if (child.is_structured()) keep_measured(child, data, domains, shown);
  }
}

NewFile figure(const Table& table) {
  const std::string_view design = embedded_file(table.figure + ".template.json");
  Json spec = Json::parse(embedded_file("common.template.json"));
  spec.update(Json::parse(design), true);
  spec["title"]["text"] = table.title;
  spec["title"]["subtitle"] = table.caption;
  const Json meta = spec.value("usermeta", Json::object());
  Json data = data_of(table, meta.value("fold", ""));
  if (meta.contains("number") && std::ranges::none_of(data, [&](const Json& datum) {
        return datum[meta["number"].get<std::string>()].is_null();
      }))
    spec["vconcat"].erase(1);
  Json shown;
  std::map<std::string, Json> domains;
  keep_measured(spec, data, domains, shown);
  if (!shown.is_null()) spec["params"][0]["value"] = std::move(shown);
  for (Json& datum : data) {
    const Json all = datum;
    for (const auto& [key, value] : all.items())
      if (design.find(key) == design.npos) datum.erase(key);
  }
  spec["datasets"]["lines"] = Json::array();
  for (const auto& [what, at] : table.lines)
    spec["datasets"]["lines"].push_back({{"what", what}, {"at", at}});
  spec["data"]["values"] = std::move(data);
  return {table.name + ".vl.json", spec.dump(1) + "\n"};
}

}  // namespace

std::vector<NewFile> figures(const Document& document) {
  std::vector<NewFile> files;
  for (const Table& table : tables_of(document))
    if (!table.figure.empty()) files.push_back(figure(table));
  return files;
}

}  // namespace desmo::report
