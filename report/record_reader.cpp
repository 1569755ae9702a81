#include "report/record_reader.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <tuple>

#include "report/environment_reader.h"
#include "report/extremes/reader.h"
#include "report/json_document.h"
#include "report/json_node.h"
#include "report/one_origin.h"
#include "report/precision/points_reader.h"
#include "report/precision/promises_reader.h"
#include "report/sizes/timed_size_reader.h"
#include "report/verification_reader.h"

namespace desmo::report {
namespace {

constexpr std::array phases{"residual", "jacobian",         "factorisation",
                            "solve",    "right_hand_sides", "rest"};

Origin read_origin(const JsonNode& node) {
  return {node.find_text("machine"), node.find_digest("model"), node.find_digest("results")};
}

CellKey read_key(const JsonNode& node) {
  return {node["case"].name(), node["coordinates"].integer(1), node["id"].text()};
}

std::optional<double> read_optional(const JsonNode& node, std::string_view key) {
  const auto member = node.find(key);
  return member ? std::optional(member->not_negative()) : std::nullopt;
}

std::vector<double> read_samples(const JsonNode& node, const std::string& what) {
  const JsonNode samples = node["cpu_seconds"];
  std::vector<double> seconds;
  for (const JsonNode& sample : samples.elements()) seconds.push_back(sample.sample());
  if (seconds.empty()) samples.complain("an \"ok\" " + what + " needs at least one sample");
  if (const auto count = node.find("repetitions"))
    if (const std::int64_t said = count->integer(1);
        said != static_cast<std::int64_t>(seconds.size()))
      samples.complain(std::to_string(seconds.size()) + " samples of " + std::to_string(said));
  return seconds;
}

template <class Read>
std::vector<double> read_each_segment(const JsonNode& list, std::size_t count, const Read& read) {
  std::vector<double> values;
  for (const JsonNode& segment : list.elements()) values.push_back(read(segment));
  if (values.size() != count)
    list.complain(std::to_string(values.size()) + " segments of " + std::to_string(count));
  return values;
}

// By instants equal, the rest shared out as desmo_bench does.
std::vector<double> instants_of_segments(std::int64_t instants, std::size_t count) {
  const auto segments = static_cast<std::int64_t>(count);
  std::vector<double> of_each;
  for (std::int64_t i = 0; i < segments; ++i)
    of_each.push_back(static_cast<double>((i + 1) * instants / segments - i * instants / segments));
  return of_each;
}

// What several threads deliver comes now from one of them and now from another: what passes until
// so many instants are there is no piece of the motion, and the least of such times belong to none.
Segments one_segment(const Settings& settings, const std::vector<double>& seconds) {
  Segments whole{.least = {std::ranges::min(seconds)},
                 .instants = {static_cast<double>(settings.instants)},
                 .updates = {0},
                 .samples = {}};
  for (const double sample : seconds) whole.samples.push_back({sample});
  return whole;
}

// None in a record without segments, and of several threads one alone. They are all that a
// repetition consists of, so that their least times cannot add up to more than the least
// repetition; a thousandth is left to the clock.
Segments read_segments(const JsonNode& node, const Settings& settings,
                       const std::vector<double>& cpu_seconds) {
  Segments segments;
  if (!settings.segments) return segments;
  const auto count = static_cast<std::size_t>(*settings.segments);
  const auto seconds = [](const JsonNode& segment) { return segment.sample(); };
  const JsonNode least = node["segment_seconds"];
  segments.least = read_each_segment(least, count, seconds);
  const double sum = std::accumulate(segments.least.begin(), segments.least.end(), 0.0);
  if (sum > 1.001 * *std::ranges::min_element(cpu_seconds))
    least.complain("together they are longer than a whole repetition");
  if (node.find("threads")) return one_segment(settings, cpu_seconds);
  const auto samples = node.find("segment_samples");
  if (!samples) return segments;
  for (const JsonNode& sample : samples->elements())
    segments.samples.push_back(read_each_segment(sample, count, seconds));
  if (segments.samples.empty()) samples->complain("there is none");
  for (std::size_t i = 0; i < count; ++i)
    if (std::ranges::none_of(segments.samples, [&](const std::vector<double>& sample) {
          return sample[i] == segments.least[i];
        }))
      least.complain("segment " + std::to_string(i) + " is not the least of its samples");
  segments.updates = read_each_segment(node["segment_updates"], count, [](const JsonNode& updates) {
    return static_cast<double>(updates.integer(0));
  });
  segments.instants = instants_of_segments(settings.instants, count);
  return segments;
}

std::vector<Solver> read_solvers(const JsonNode& node) {
  std::vector<Solver> solvers;
  if (const auto list = node.find("solvers"))
    for (const JsonNode& solver : list->elements()) {
      const JsonNode unknowns = solver["unknowns"];
      const std::vector<JsonNode> range = unknowns.elements();
      if (range.size() != 2) unknowns.complain("the least and the most were expected");
      solvers.push_back({solver["algebra"].text(),
                         solver["parts"].integer(1),
                         {range[0].integer(1), range[1].integer(1)}});
    }
  return solvers;
}

Cell read_cell(const JsonNode& node, const Settings& settings) {
  Cell cell{.status = read_status(node["status"]),
            .message = {},
            .origin = read_origin(node),
            .cpu_seconds = {},
            .segments = {},
            .verification = std::nullopt,
            .setup_seconds = read_optional(node, "setup_seconds"),
            .iterations_per_step = read_optional(node, "iterations_per_step"),
            .residual = read_optional(node, "residual"),
            .solvers = read_solvers(node)};
  if (const auto message = node.find("message")) cell.message = message->text();
  if (const auto checked = node.find("verification"))
    cell.verification = read_verification(*checked);
  if (cell.status != Status::ok) return cell;  // times of a wrong answer are not times
  if (!cell.verification) node.complain("an \"ok\" cell needs \"verification\"");
  cell.cpu_seconds = read_samples(node, "cell");
  cell.segments = read_segments(node, settings, cell.cpu_seconds);
  if (!settings.allowed) return cell;
  if (std::string reason = excess(*cell.verification, *settings.allowed); !reason.empty()) {
    cell.status = Status::failed;
    cell.message = std::move(reason);
    cell.cpu_seconds.clear();
    cell.segments = {};
  }
  return cell;
}

std::array<double, 2> read_range(const JsonNode& node) {
  const std::vector<JsonNode> ends = node.elements();
  if (ends.size() != 2) node.complain("two numbers were expected, smallest and largest");
  const std::array range{ends[0].not_negative(), ends[1].not_negative()};
  if (range[0] > range[1]) node.complain("the smallest exceeds the largest");
  return range;
}

Profile read_profile(const JsonNode& node) {
  Profile profile;
  const JsonNode split = node["seconds_per_step"];
  for (const char* phase : phases)
    profile.seconds_per_step.emplace_back(phase, split[phase].not_negative());
  for (const auto& [phase, seconds] : split.members())
    if (std::find(phases.begin(), phases.end(), phase) == phases.end())
      profile.seconds_per_step.emplace_back(phase, seconds.not_negative());
  if (const auto range = node.find("total_range")) profile.total_range = read_range(*range);
  return profile;
}

Structure read_structure(const JsonNode& node) {
  Structure structure;
  if (const auto units = node.find("units")) structure.units = units->integer(1);
  const JsonNode parts = node["parts"];
  for (const JsonNode& part : parts.elements()) {
    const PartSizes sizes{part["unknowns"].integer(1), part["count"].integer(1)};
    if (!structure.parts.empty() && structure.parts.back().unknowns <= sizes.unknowns)
      part["unknowns"].complain("the parts do not stand largest first, each size once");
    structure.parts.push_back(sizes);
  }
  if (structure.parts.empty()) parts.complain("a structure needs at least one part");
  return structure;
}

std::string read_level(const JsonNode& node) {
  const std::string level = node.text();
  if (level != "position" && level != "velocity" && level != "acceleration")
    node.complain("\"" + level + "\" is none of \"position\", \"velocity\", \"acceleration\"");
  return level;
}

// Only the levels asked were compared.
std::string request_excess(const JsonNode& verification, const Allowed& allowed) {
  Verification found{.instants = verification["instants"].integer(1),
                     .position = verification["position"].not_negative()};
  found.velocity = read_optional(verification, "velocity").value_or(0);
  found.acceleration = read_optional(verification, "acceleration").value_or(0);
  return excess(found, allowed);
}

Request read_request(const JsonNode& node, const Settings& settings) {
  Request request{.cell = read_key(node),
                  .name = node["request"].name(),
                  .title = node["title"].text(),
                  .level = read_level(node["level"]),
                  .unknowns = node["unknowns"].integer(1),
                  .all_unknowns = node["all_unknowns"].integer(1),
                  .status = read_status(node["status"]),
                  .message = {},
                  .origin = read_origin(node),
                  .cpu_seconds = {},
                  .segments = {},
                  .difference = read_optional(node, "difference"),
                  .iterations_per_step = read_optional(node, "iterations_per_step")};
  if (request.unknowns > request.all_unknowns)
    node["unknowns"].complain("more unknowns than the whole mechanism has");
  if (const auto message = node.find("message")) request.message = message->text();
  if (request.status != Status::ok) return request;  // times of a wrong answer are not times
  const JsonNode verification = node["verification"];
  if (!request.difference) node.complain("an \"ok\" request needs \"difference\"");
  request.cpu_seconds = read_samples(node, "request");
  request.segments = read_segments(node, settings, request.cpu_seconds);
  const std::optional<Allowed>& allowed = settings.allowed;
  if (!allowed) return request;
  std::string reason = request_excess(verification, *allowed);
  if (reason.empty() && allowed->request)
    reason =
        excess("the answer beside the whole mechanism's", *request.difference, *allowed->request);
  if (!reason.empty()) {
    request.status = Status::failed;
    request.message = std::move(reason);
    request.cpu_seconds.clear();
    request.segments = {};
  }
  return request;
}

Peer read_peer(const JsonNode& node, const Settings& settings) {
  Peer peer{.case_name = node["case"].name(),
            .coordinates = node["coordinates"].integer(1),
            .name = node["peer"].name(),
            .library = node["library"].text(),
            .library_version = node["library_version"].text(),
            .method = node["method"].text(),
            .guess = node["guess"].name(),
            .setup = {},
            .compared = std::nullopt,
            .cell = read_cell(node, settings)};
  if (const auto setup = node.find("setup")) peer.setup = setup->text();
  if (const auto compared = node.find("compared")) peer.compared = compared->integer(1);
  if (peer.compared && *peer.compared > peer.coordinates)
    node["compared"].complain("more coordinates than the mechanism has");
  return peer;
}

void read_structures(Record& record, const JsonNode& list) {
  for (const JsonNode& node : list.elements()) {
    const StructureKey key{node["case"].name(), node["coordinates"].integer(1),
                           node["partition"].name()};
    if (!record.structure.emplace(key, read_structure(node)).second)
      node.complain("the structure of " + key.case_name + "/" + std::to_string(key.coordinates) +
                    "/" + key.partition + " is given twice");
  }
}

void read_requests(Record& record, const JsonNode& list) {
  std::set<std::pair<CellKey, std::string>> seen;
  for (const JsonNode& node : list.elements()) {
    record.requests.push_back(read_request(node, record.settings));
    const Request& request = record.requests.back();
    if (!seen.emplace(request.cell, request.name).second)
      node.complain("the request " + request.name + " of " + request.cell.id + " is given twice");
  }
}

void read_peers(Record& record, const JsonNode& list) {
  std::set<std::tuple<std::string, std::int64_t, std::string>> seen;
  for (const JsonNode& node : list.elements()) {
    record.peers.push_back(read_peer(node, record.settings));
    const Peer& peer = record.peers.back();
    if (!seen.emplace(peer.case_name, peer.coordinates, peer.name).second)
      node.complain(peer.case_name + "/" + std::to_string(peer.coordinates) + "/peer:" + peer.name +
                    " is given twice");
  }
}

template <typename Map, typename Value>
void insert_once(Map& map, const JsonNode& node, Value value) {
  const CellKey key = read_key(node);
  if (!map.emplace(key, std::move(value)).second)
    node.complain(key.case_name + "/" + std::to_string(key.coordinates) + "/" + key.id +
                  " is given twice");
}

void read_instructions(Record& record, const JsonNode& list) {
  for (const JsonNode& node : list.elements())
    insert_once(record.instructions, node,
                StepCount{node["instructions_per_step"].integer(1), node["steps"].integer(1),
                          node["tool"].text()});
}

}  // namespace

Record read_record(const JsonNode& root) {
  check_schema(root, "desmo-results");
  const JsonNode node = root["record"];
  const JsonNode blas = node["blas"];
  Record record{.version = root["version"].text(),
                .date = node["date"].utc(),
                .commit = node["commit"].text(),
                .dirty = node["dirty"].boolean(),
                .command = node["command"].text(),
                .machine = read_machine(node["machine"]),
                .build = read_build(node["build"]),
                .libraries = {},
                .blas = {blas["core"].text(), blas["threads"].integer(1)},
                .settings = read_settings(node["settings"]),
                .cells = {},
                .profiles = {},
                .structure = {},
                .requests = {},
                .peers = {},
                .floors = {},
                .points = {},
                .promises = {},
                .growth = {},
                .crossing = {},
                .instructions = {},
                .extreme_rows = {},
                .extremes = {}};
  for (const auto& [name, version] : node["libraries"].members())
    record.libraries.emplace(name, version.text());
  for (const JsonNode& cell : root["cells"].elements())
    insert_once(record.cells, cell, read_cell(cell, record.settings));
  if (const auto profiles = root.find("profiles"))
    for (const JsonNode& profile : profiles->elements())
      insert_once(record.profiles, profile, read_profile(profile));
  if (const auto structure = root.find("structure")) read_structures(record, *structure);
  if (const auto requests = root.find("requests")) read_requests(record, *requests);
  if (const auto peers = root.find("peers")) read_peers(record, *peers);
  read_points(record, root);
  read_promises(record, root);
  read_sizes(record, root);
  if (const auto instructions = root.find("instructions")) read_instructions(record, *instructions);
  read_extremes(record, root);
  if (!has_cells(record) && record.points.empty() && record.promises.empty() &&
      !has_sizes(record) && record.instructions.empty() && record.extremes.empty())
    root["cells"].complain(
        "the record has no cell, and neither requests, peers, points, promises, sizes, "
        "instructions "
        "nor extremes");
  require_one_origin(record);
  return record;
}

Record parse_record(std::string_view text) {
  const nlohmann::json document = parse_json(text);
  return read_record(JsonNode(document));
}

Record read_record(const std::filesystem::path& file) { return parse_record(read_whole(file)); }

}  // namespace desmo::report
