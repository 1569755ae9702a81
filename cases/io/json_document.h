// JSON document whose values know their position, so that every error names it.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace desmo {

class JsonValue;

/// Parsed JSON text. Values stand in one list in the order of the text, each before its contents.
/// So building, searching and destroying need no recursion, and large documents little memory.
class JsonDocument {
 public:
  /// Parses strictly: no key twice in an object, finite numbers only, at most 32 levels. Throws
  /// InputError.
  JsonDocument(std::string_view text, std::string file_name);
  JsonDocument(const JsonDocument&) = delete;
  JsonDocument& operator=(const JsonDocument&) = delete;

  JsonValue root() const;

 private:
  friend class JsonValue;
  class Builder;

  enum class Kind : std::uint8_t { null, boolean, number, string, array, object };

  struct Span {
    std::uint32_t begin = 0, size = 0;
  };

  struct Node {
    double number = 0;      // a boolean is 0 or 1
    Span text, key;         // positions in texts_
    std::uint32_t end = 0;  // first node after this one's contents; 0: not read yet
    Kind kind = Kind::null;
  };

  std::string_view view(Span span) const {
    return std::string_view(texts_).substr(span.begin, span.size);
  }
  std::string pointer(std::uint32_t node) const;
  [[noreturn]] void complain(const std::string& place, const std::string& what) const;

  std::vector<Node> nodes_;
  std::string texts_;
  std::string file_name_;
};

/// Reference to a value of a document, which must outlive it. All functions throw InputError,
/// naming file and position, when the value is not of the requested kind.
class JsonValue {
 public:
  bool is_string() const { return kind() == JsonDocument::Kind::string; }
  bool is_number() const { return kind() == JsonDocument::Kind::number; }
  bool is_array() const { return kind() == JsonDocument::Kind::array; }
  bool is_object() const { return kind() == JsonDocument::Kind::object; }

  std::string_view key() const;                               ///< key in its object
  std::vector<JsonValue> members() const;                     ///< members of an object
  std::vector<JsonValue> elements() const;                    ///< elements of an array
  std::optional<JsonValue> find(std::string_view key) const;  ///< optional member
  JsonValue operator[](std::string_view key) const;           ///< required member
  /// Throws InputError, with an example of an object, if it is none.
  void require_object(std::string_view example) const;
  /// Throws InputError if there are members with other keys.
  void allow(std::initializer_list<std::string_view> keys) const;

  std::string_view text() const;
  std::string_view line() const;  ///< non-empty text of one line and at most 200 characters
  double number() const;          ///< at most 1e100 in magnitude, so that squares are finite
  int whole_number(int least, int most) const;
  /// Returns the position of the text in a list; kind: "level", for the message when it is not
  /// there.
  std::size_t choose(const std::string& kind, std::span<const std::string_view> known) const;
  bool boolean() const;

  /// Throws InputError. what: "<what is wrong>; <remedy>".
  [[noreturn]] void complain(const std::string& what) const;

 private:
  friend class JsonDocument;

  JsonValue(const JsonDocument* document, std::uint32_t node) : document_(document), node_(node) {}
  const JsonDocument::Node& node() const { return document_->nodes_[node_]; }
  JsonDocument::Kind kind() const { return node().kind; }
  std::vector<JsonValue> children() const;
  void expect(JsonDocument::Kind kind, const char* what) const;

  const JsonDocument* document_;
  std::uint32_t node_;
};

}  // namespace desmo
