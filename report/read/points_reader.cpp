#include "report/read/points_reader.h"

#include "report/read/time_reader.h"

namespace desmo::report {
namespace {

SeriesKey read_series(const JsonNode& node) {
  return {node["case"].name(), node["coordinates"].integer(1), node["step_seconds"].positive(),
          node["instants"].integer(2)};
}

PerLevel read_levels(const JsonNode& node) {
  return {node["position"].not_negative(), node["velocity"].not_negative(),
          node["acceleration"].not_negative()};
}

Floor read_floor(const JsonNode& node) {
  Floor floor{.compared = node["compared"].integer(2),
              .reference = read_levels(node["reference"]),
              .condition = std::nullopt,
              .in_double = std::nullopt,
              .in_float = std::nullopt};
  const auto condition = node.find("condition");
  if (!condition) return floor;
  floor.condition = condition->positive();
  floor.in_double = read_levels(node["limit"]["double"]);
  floor.in_float = read_levels(node["limit"]["float"]);
  return floor;
}

std::optional<LevelError> read_error(const JsonNode& errors, const char* level) {
  const auto node = errors.find(level);
  if (!node) return std::nullopt;
  const LevelError error{(*node)["max"].not_negative(), (*node)["rms"].not_negative()};
  if (error.rms > error.max * (1 + 1e-12)) (*node)["rms"].complain("it exceeds the largest");
  return error;
}

Errors read_errors(const JsonNode& node) {
  return {read_error(node, "position"), read_error(node, "velocity"),
          read_error(node, "acceleration")};
}

Point::Status read_point_status(const JsonNode& node) {
  const std::string status = node.text();
  if (status == "ok") return Point::Status::ok;
  if (status == "failed") return Point::Status::failed;
  if (status == "not_applicable") return Point::Status::not_applicable;
  node.complain("\"" + status + "\" is none of \"ok\", \"failed\", \"not_applicable\"");
}

Configuration read_configuration(const JsonNode& node) {
  const std::string id = node.text();
  if (auto configuration = parse_configuration(id)) return *std::move(configuration);
  node.complain("\"" + id + "\" is not a formulation with settings, /key:value, each once");
}

Point read_point(const JsonNode& node) {
  Point point{.configuration = read_configuration(node["id"]),
              .status = read_point_status(node["status"]),
              .message = {},
              .error = {},
              .violation = {},
              .iterations_per_step = 0,
              .seconds_per_step = {}};
  if (const auto message = node.find("message")) point.message = message->text();
  if (point.status != Point::Status::ok) return point;
  point.error = read_errors(node["error"]);
  point.violation = read_errors(node["violation"]);
  point.iterations_per_step = node["iterations_per_step"].not_negative();
  point.seconds_per_step = read_cpu_seconds(node["time_per_step"]);
  if (point.error.position) return point;
  point.status = Point::Status::failed;
  point.message = "the positions found are beyond all measure";
  point.seconds_per_step.clear();
  return point;
}

std::string described(const SeriesKey& series) {
  return series.case_name + "/" + std::to_string(series.coordinates) + " with " +
         std::to_string(series.instants) + " instants";
}

}  // namespace

void read_points(Record& record, const JsonNode& section) {
  if (const auto floors = section.find("floors"))
    for (const JsonNode& node : floors->elements())
      if (const SeriesKey key = read_series(node);
          !record.floors.emplace(key, read_floor(node)).second)
        node.complain("the floor of " + described(key) + " is given twice");
  const auto points = section.find("points");
  if (!points) return;
  for (const JsonNode& node : points->elements()) {
    const PointKey key{read_series(node), node["id"].text()};
    if (!record.floors.contains(key.series))
      node.complain("\"floors\" has nothing of " + described(key.series));
    if (!record.points.emplace(key, read_point(node)).second)
      node.complain(key.id + " of " + described(key.series) + " is given twice");
  }
}

}  // namespace desmo::report
