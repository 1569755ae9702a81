#include "report/read/json_document.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "report/read/json_node.h"

namespace desmo::report {
namespace {

// Refuses what the parser would accept and the report must not: a key given twice (which one
// counts?) and nesting without end.
class DocumentGuard {
 public:
  bool operator()(int depth, nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > max_nesting)
      throw InvalidRecord("nested more than " + std::to_string(max_nesting) + " levels deep");
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(parsed.get<std::string>()).second)
      throw InvalidRecord("the key " + parsed.dump() + " is given twice in one object");
    return true;
  }

 private:
  std::vector<std::set<std::string>> keys_;  // of the objects that are open
};

/// What makes a document anew, by a key that it has: records before 2.0.0 named no experiment.
struct Remedy {
  const char* key;
  const char* command;
};

constexpr std::array<Remedy, 7> remedies{{{"head", "bench/check --renew-baseline"},
                                          {"precision", "bench/run accuracy"},
                                          {"promises", "bench/run accuracy"},
                                          {"growth", "bench/run size"},
                                          {"crossing", "bench/run size"},
                                          {"instructions", "bench/run instructions"},
                                          {"extremes", "bench/run extremes"}}};

std::string remedy_of(const JsonNode& root) {
  for (const Remedy& remedy : remedies)
    if (root.find(remedy.key)) return remedy.command;
  return "bench/run";
}

// One version is read; an older one is measured anew, a newer one needs a newer program.
void check_version(const JsonNode& root) {
  const bool old = !root.find("schema_version") && root.find("version");
  const char* const key = old ? "version" : "schema_version";
  const std::string version = root[key].text();
  if (version == schema_version) return;
  const std::string what = std::string(key) + ": schema version " + version + ", and only " +
                           schema_version + " is read";
  const bool newer = std::atoi(version.c_str()) >= std::atoi(schema_version);
  throw UnsupportedVersion(what + (newer ? "; a newer desmo_report may read it"
                                         : "; measure it anew with " + remedy_of(root)));
}

}  // namespace

nlohmann::json parse_json(std::string_view text) {
  DocumentGuard guard;
  try {
    return nlohmann::json::parse(text, [&guard](int depth, auto event, nlohmann::json& parsed) {
      return guard(depth, event, parsed);
    });
  } catch (const nlohmann::json::exception& error) {
    const char* what = std::strstr(error.what(), "] ");  // past the library's own error number
    throw InvalidRecord(std::string("not a complete JSON document: ") +
                        (what ? what + 2 : error.what()));
  }
}

void check_schema(const JsonNode& root, const std::string& name) {
  const std::string schema = root["schema"].text();
  if (schema != name) root["schema"].complain("\"" + schema + "\" is not \"" + name + "\"");
  check_version(root);
}

}  // namespace desmo::report
