// A place in a JSON document that knows its path, so that every complaint names it.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace desmo::report {

/// Refers to a value of the document, which must outlive it. Everything throws InvalidRecord when
/// the value is not what is asked for.
class JsonNode {
 public:
  explicit JsonNode(const nlohmann::json& value, std::string path = {})
      : value_(&value), path_(std::move(path)) {}

  JsonNode operator[](std::string_view key) const;                ///< required member of an object
  std::optional<JsonNode> find(std::string_view key) const;       ///< optional member of an object
  std::vector<std::pair<std::string, JsonNode>> members() const;  ///< of an object, by name
  std::vector<JsonNode> elements() const;                         ///< of an array

  /// Optional members of an object, as text() and digest().
  std::optional<std::string> find_text(std::string_view key) const;
  std::optional<std::string> find_digest(std::string_view key) const;

  std::string text() const;    ///< control characters, which a terminal would obey, become spaces
  std::string name() const;    ///< letters, digits, "_" and "-" only: it becomes part of file names
  std::string digest() const;  ///< SHA-256: 64 hexadecimal digits in lower case
  std::string utc() const;     ///< a date that there is, and a time: 2026-11-21T17:48:47Z
  bool boolean() const;
  std::int64_t integer(std::int64_t least) const;  ///< in least ... 1e9
  double number() const;
  double not_negative() const;  ///< and at most 1e100, so that sums stay finite
  double positive() const;      ///< likewise
  double sample() const;        ///< a measured time, 1e-9 s ... 1e9 s: no clock gives another

  [[noreturn]] void complain(const std::string& what) const;

 private:
  const nlohmann::json* value_;
  std::string path_;
};

}  // namespace desmo::report
