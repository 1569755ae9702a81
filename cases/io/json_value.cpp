#include <algorithm>
#include <cmath>

#include "cases/io/json_document.h"
#include "cases/mechanism/names.h"

namespace desmo {

std::string_view JsonValue::key() const { return document_->view(node().key); }

std::vector<JsonValue> JsonValue::children() const {
  std::vector<JsonValue> result;
  for (std::uint32_t at = node_ + 1; at < node().end; at = document_->nodes_[at].end)
    result.push_back({document_, at});
  return result;
}

std::vector<JsonValue> JsonValue::members() const {
  expect(JsonDocument::Kind::object, "an object, { … }");
  return children();
}

std::vector<JsonValue> JsonValue::elements() const {
  expect(JsonDocument::Kind::array, "a list, [ … ]");
  return children();
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
  expect(JsonDocument::Kind::object, "an object, { … }");
  for (std::uint32_t at = node_ + 1; at < node().end; at = document_->nodes_[at].end)
    if (document_->view(document_->nodes_[at].key) == key) return JsonValue(document_, at);
  return std::nullopt;
}

JsonValue JsonValue::operator[](std::string_view key) const {
  if (auto member = find(key)) return *member;
  complain("the key " + in_quotes(key) + " is missing; add it");
}

void JsonValue::require_object(std::string_view example) const {
  if (is_object()) return;
  expect(JsonDocument::Kind::object, ("an object such as " + std::string(example)).c_str());
}

void JsonValue::allow(std::initializer_list<std::string_view> keys) const {
  for (const JsonValue& member : members())
    if (std::ranges::find(keys, member.key()) == keys.end())
      member.complain(unknown_name("key", member.key(), {keys.begin(), keys.size()}));
}

std::string_view JsonValue::text() const {
  expect(JsonDocument::Kind::string, "a text");
  return document_->view(node().text);
}

std::string_view JsonValue::line() const {
  constexpr std::size_t max_line = 200;
  const std::string_view line = text();
  if (line.empty()) complain("is empty; give a text");
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (std::ranges::any_of(line, is_control))
    complain(in_quotes(line) + " has control characters; leave them out");
  if (characters(line) > max_line)
    complain(in_quotes(line) + " is longer than " + std::to_string(max_line) +
             " characters; shorten it");
  return line;
}

double JsonValue::number() const {
  constexpr double max_number = 1e100;
  expect(JsonDocument::Kind::number, "a number");
  if (!(std::abs(node().number) <= max_number))
    complain("the number is too large; give one below 1e100");
  return node().number;
}

int JsonValue::whole_number(int least, int most) const {
  const double value = number();
  if (value != std::floor(value) || value < least || value > most)
    complain("must be a whole number from " + std::to_string(least) + " to " +
             std::to_string(most) + "; choose one");
  return static_cast<int>(value);
}

std::size_t JsonValue::choose(const std::string& kind,
                              std::span<const std::string_view> known) const {
  const auto found = std::ranges::find(known, text());
  if (found != known.end()) return found - known.begin();
  complain(unknown_name(kind, text(), known));
}

bool JsonValue::boolean() const {
  expect(JsonDocument::Kind::boolean, "true or false");
  return node().number != 0;
}

void JsonValue::complain(const std::string& what) const {
  document_->complain(document_->pointer(node_), what);
}

void JsonValue::expect(JsonDocument::Kind expected, const char* what) const {
  if (kind() == expected) return;
  // Words for the kinds, in the order of Kind.
  static constexpr const char* names[] = {"null",   "false",  "a number",
                                          "a text", "a list", "an object"};
  const bool is_true = kind() == JsonDocument::Kind::boolean && node().number != 0;
  complain(std::string("is ") + (is_true ? "true" : names[static_cast<int>(kind())]) + "; give " +
           what);
}

}  // namespace desmo
