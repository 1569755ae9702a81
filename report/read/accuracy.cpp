// The experiment accuracy: floors and points.
#include <algorithm>
#include <array>

#include "report/read/readers.h"

namespace desmo::report {
namespace {

SeriesKey read_series(const RecordValue& node) {
  return {read_case_size(node), node["step_seconds"].positive(), node["instants"].integer(2)};
}

Floor read_floor(const RecordValue& node) {
  Floor floor{.reference = read_levels(node["reference"], &RecordValue::not_negative)};
  if (!node.maybe("condition", &RecordValue::positive)) return floor;
  floor.in_double = read_levels(node["limit"]["double"], &RecordValue::not_negative);
  floor.in_float = read_levels(node["limit"]["float"], &RecordValue::not_negative);
  return floor;
}

MaxErrors read_errors(const RecordValue& node) {
  const auto max = [](const RecordValue& error) { return error["max"].not_negative(); };
  return {node.maybe("position", max), node.maybe("velocity", max),
          node.maybe("acceleration", max)};
}

Configuration read_configuration(const RecordValue& node) {
  const std::string id = node.text();
  if (auto configuration = parse_configuration(id)) return *std::move(configuration);
  node.complain(in_double_quotes(id) +
                " is not a formulation with settings, /key:value, each once");
}

Point read_point(const RecordValue& node) {
  constexpr std::array statuses{Status::ok, Status::failed, Status::not_applicable};
  Point point;
  point.configuration = read_configuration(node["id"]);
  point.status = statuses[node["status"].one_of({"ok", "failed", "not_applicable"})];
  point.message = node.maybe("message", &RecordValue::text).value_or("");
  if (point.status != Status::ok) return point;
  point.error = read_errors(node["error"]);
  point.iterations_per_step = node["iterations_per_step"].not_negative();
  point.time = read_step_time(node["time_per_step"]);
  if (!point.error.position) fail(point, "the positions found are beyond all measure");
  return point;
}

std::string described(const SeriesKey& series) {
  return series.case_name + "/" + std::to_string(series.coordinates) + " with " +
         std::to_string(series.instants) + " instants";
}

}  // namespace

void read_accuracy(Record& record, const RecordValue& experiment) {
  read_each(experiment, "floors", [&](const RecordValue& node) {
    const SeriesKey key = read_series(node);
    add_once(record.floors, node, key, read_floor(node), "the floor of " + described(key));
  });
  read_each(experiment, "points", [&](const RecordValue& node) {
    const PointKey key{read_series(node), node["id"].text()};
    if (!record.floors.contains(key.series))
      node.complain("\"floors\" has nothing of " + described(key.series));
    add_once(record.points, node, key, read_point(node), key.id + " of " + described(key.series));
  });
  const auto is_drawn = [&](const auto& point) {
    return point.first.series.step_seconds == record.settings.step_seconds;
  };
  if (!record.points.empty() && std::ranges::none_of(record.points, is_drawn))
    experiment["points"].complain("none has the step of the record's settings");
}

}  // namespace desmo::report
