#include "report/json_document.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "report/json_node.h"

namespace desmo::report {
namespace {

// Refuses what the parser would accept and the report must not: a key given twice (which one
// counts?) and nesting without end.
class DocumentGuard {
 public:
  bool operator()(int depth, nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > deepest_nesting)
      throw InvalidRecord("nested more than " + std::to_string(deepest_nesting) + " levels deep");
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(parsed.get<std::string>()).second)
      throw InvalidRecord("the key " + parsed.dump() + " is given twice in one object");
    return true;
  }

 private:
  std::vector<std::set<std::string>> keys_;  // of the objects that are open
};

// "1.4.2" -> 1. Nothing but three numbers will do.
int major_version(const JsonNode& node) {
  const std::string version = node.text();
  const char* at = version.data();
  const char* const end = at + version.size();
  std::array<int, 3> part{};
  for (std::size_t i = 0; i < part.size(); ++i) {
    const bool separated = i == 0 || (at != end && *at++ == '.');
    const auto [next, error] = std::from_chars(at, end, part[i]);
    if (!separated || error != std::errc{} || part[i] < 0)
      node.complain("\"" + version + "\" is not a version of the form 1.2.3");
    at = next;
  }
  if (at != end) node.complain("\"" + version + "\" is not a version of the form 1.2.3");
  return part[0];
}

}  // namespace

std::string read_whole(const std::filesystem::path& file) {
  std::error_code unreadable;  // is for the stream to say
  if (std::filesystem::is_directory(file, unreadable)) throw UnreadableFile("is a directory");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw UnreadableFile(std::string("cannot be read: ") + std::strerror(errno));
  std::string text;
  std::array<char, 1 << 16> buffer;
  while (stream.read(buffer.data(), buffer.size()), stream.gcount() > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > largest_record)
      throw InvalidRecord("larger than " + std::to_string(largest_record) + " bytes");
  }
  if (stream.bad()) throw UnreadableFile("cannot be read to its end");
  return text;
}

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
  const JsonNode version = root["version"];
  const int major = major_version(version);
  if (major != supported_major)
    throw UnsupportedVersion("version: schema version " + version.text() +
                             " is not supported, only " + std::to_string(supported_major) + ".x.y" +
                             (major > supported_major ? "; a newer desmo_report reads it" : ""));
}

}  // namespace desmo::report
