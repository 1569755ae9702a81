// A JSON document whose values know their place in it, so that every error names it.
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

/// A parsed JSON text. Values stand in one list in the order of the text, each before its contents.
/// Building, searching and destroying thus need no recursion, and large documents little memory.
class JsonDocument {
 public:
  /// Parses a text; comments count as blanks (comments.h). Throws InputError unless it is JSON of
  /// at most 64 MiB, 10⁷ values and 32 levels. Numbers must be finite, and keys unique in an
  /// object.
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
    double number = 0;      // value of a number; of a boolean 0 or 1
    Span text, key;         // ranges of texts_: value of a string; key in the object around it
    std::uint32_t end = 0;  // index of the first node after this one's contents; 0: still reading
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

/// Reference to a value of a document, which must outlive it. Functions that read the value throw
/// InputError, naming file and place, when it is not of the requested kind.
class JsonValue {
 public:
  bool is_string() const { return kind() == JsonDocument::Kind::string; }
  bool is_number() const { return kind() == JsonDocument::Kind::number; }
  bool is_array() const { return kind() == JsonDocument::Kind::array; }
  bool is_object() const { return kind() == JsonDocument::Kind::object; }

  std::string_view key() const;             ///< key in the object around it; empty in an array
  std::vector<JsonValue> members() const;   ///< members of an object
  std::vector<JsonValue> elements() const;  ///< elements of an array
  std::optional<JsonValue> find(std::string_view key) const;  ///< optional member of an object
  JsonValue operator[](std::string_view key) const;           ///< required member of an object
  /// Throws InputError, with an example of an object, if it is none.
  void require_object(std::string_view example) const;
  /// Throws InputError if the object has members with other keys.
  void allow(std::initializer_list<std::string_view> keys) const;

  std::string_view text() const;
  std::string_view line() const;  ///< text of 1 to 200 characters, none a control character
  double number() const;          ///< number, ≤ 1e100 in magnitude, so that squares are finite
  int whole_number(int least, int most) const;  ///< whole number, least ≤ it ≤ most
  /// Returns the index of the text in a list. Throws InputError when it is not there.
  /// - kind: word for what is listed, such as "level", for the message
  std::size_t choose(const std::string& kind, std::span<const std::string_view> known) const;
  bool boolean() const;

  /// Throws InputError that names the place of the value. what: "<what is wrong>; <remedy>".
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
