// desmo list: the mechanisms, scalable cases and formulations of the program.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/cli/commands.h"
#include "bench/cli/input.h"
#include "bench/cli/text.h"
#include "cases/generators/cases.h"
#include "cases/io/new_files.h"
#include "cases/library/library.h"
#include "cases/mechanism/names.h"
#include "formulations/variants.h"

namespace desmo::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ListOptions {
  std::string what;  // key of the section to list; empty: all sections
  bool json = false;
};

Json mechanisms() {
  Json list = Json::array();
  for (const LibraryMechanism& found : library()) {
    const Input input = load_mechanism(std::string(found.name));
    const Model m = model_mechanism(input).model;
    const Mechanism& mechanism = input.scene.mechanism;
    list.push_back({{"name", found.name},
                    {"dimension", mechanism.dimension},
                    {"bodies", mechanism.bodies.size() - 1},
                    {"degrees_of_freedom", m.degrees_of_freedom()},
                    {"coordinates", m.coordinates()},
                    {"title", mechanism.title}});
  }
  return list;
}

Json scalable_cases() {
  Json list = Json::array();
  for (const Case& c : cases())
    list.push_back({{"name", c.name},
                    {"unit", c.unit_name},
                    {"base_coordinates", c.base_coordinates},
                    {"coordinates_per_unit", c.coordinates_per_unit},
                    {"sizes", c.sizes},
                    {"extra_sizes", c.extra_sizes}});
  return list;
}

Json formulations() {
  Json list = Json::array();
  for (const Variant& v : variants()) {
    const std::size_t first = v.id.find('_'), last = v.id.rfind('_');
    list.push_back({{"id", v.id},
                    {"partition", v.id.substr(0, first)},
                    {"equations", v.id.substr(first + 1, last - first - 1)},
                    {"algebra", v.algebra}});
  }
  return list;
}

std::string text_of(const Json& value) {
  if (value.is_string()) return printable(value.get<std::string>(), 200);
  if (!value.is_array()) return value.dump();
  std::vector<std::string> items;
  for (const Json& item : value) items.push_back(text_of(item));
  return items.empty() ? "-" : enumerate(items);
}

struct Section {
  const char* key;
  Json (*collect)();
  const char* title;
};

constexpr Section sections[] = {
    {"mechanisms", mechanisms,
     "Library mechanisms (desmo show NAME, desmo inspect NAME, desmo solve NAME)"},
    {"cases", scalable_cases,
     "Scalable cases, written NAME:UNITS, such as truck_suspension:5; sizes of the benchmark in "
     "coordinates"},
    {"formulations", formulations, "Formulations"},
};

/// Returns a table of entries that have the same keys, numbers aligned to the right.
std::string to_text(const Section& section, const Json& entries) {
  std::vector<std::vector<std::string>> rows(1);
  std::string right;
  for (const auto& [key, value] : entries.front().items()) {
    std::string& heading = rows.front().emplace_back(key);
    std::ranges::replace(heading, '_', ' ');
    right += value.is_number() ? 'r' : 'l';
  }
  for (const Json& entry : entries) {
    std::vector<std::string>& row = rows.emplace_back();
    for (const Json& value : entry) row.push_back(text_of(value));
  }
  return std::string(section.title) + "\n" + table(rows, right);
}

void list(const ListOptions& options) {
  const auto is_wanted = [&](std::string_view what) {
    return options.what.empty() || options.what == what;
  };
  Json all = Json::object();
  std::string text;
  for (const Section& section : sections) {
    if (!is_wanted(section.key)) continue;
    all[section.key] = section.collect();
    text += (text.empty() ? "" : "\n") + to_text(section, all[section.key]);
  }
  write_standard_output(options.json ? all.dump(1) + "\n" : text);
  if (is_wanted("formulations"))
    for (const std::string& note : faulty_libraries())
      std::fprintf(stderr, "desmo: %s\n", printable(note, 500).c_str());
}

}  // namespace

void add_list(CLI::App& program) {
  const auto [command, options] = add_command(
      program, "list", "Mechanisms, scalable cases and formulations that there are", list);
  command.add_option("what", options.what, "What to list; everything by default")
      ->check(CLI::IsMember({"mechanisms", "cases", "formulations"}));
  command.add_flag("--json", options.json, "As JSON");
  command.footer(
      "Examples:\n"
      "  desmo list mechanisms\n"
      "  desmo list formulations --json");
}

}  // namespace desmo::cli
