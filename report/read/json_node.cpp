#include "report/read/json_node.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "report/read/json_document.h"

namespace desmo::report {
namespace {

constexpr std::int64_t max_integer = 1'000'000'000;
constexpr double max_number = 1e100;
constexpr double min_sample = 1e-9;
constexpr double max_sample = 1e9;

}  // namespace

void JsonNode::complain(const std::string& what) const {
  throw InvalidRecord((path_.empty() ? "top level" : path_) + ": " + what);
}

JsonNode JsonNode::operator[](std::string_view key) const {
  if (auto member = find(key)) return *member;
  complain("the required key \"" + std::string(key) + "\" is missing");
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const {
  if (!value_->is_object())
    complain(std::string("an object was expected, not ") + value_->type_name());
  const auto member = value_->find(key);
  if (member == value_->end()) return std::nullopt;
  return JsonNode(*member, (path_.empty() ? "" : path_ + ".") + std::string(key));
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::members() const {
  if (!value_->is_object())
    complain(std::string("an object was expected, not ") + value_->type_name());
  std::vector<std::pair<std::string, JsonNode>> result;
  for (const auto& [key, member] : value_->items())
    result.emplace_back(key, JsonNode(member, (path_.empty() ? "" : path_ + ".") + key));
  return result;
}

std::vector<JsonNode> JsonNode::elements() const {
  if (!value_->is_array())
    complain(std::string("an array was expected, not ") + value_->type_name());
  std::vector<JsonNode> result;
  for (std::size_t i = 0; i < value_->size(); ++i)
    result.emplace_back((*value_)[i], path_ + "[" + std::to_string(i) + "]");
  return result;
}

std::optional<std::string> JsonNode::find_text(std::string_view key) const {
  const auto member = find(key);
  return member ? std::optional(member->text()) : std::nullopt;
}

std::optional<std::string> JsonNode::find_digest(std::string_view key) const {
  const auto member = find(key);
  return member ? std::optional(member->digest()) : std::nullopt;
}

std::string JsonNode::text() const {
  if (!value_->is_string())
    complain(std::string("a string was expected, not ") + value_->type_name());
  std::string text = value_->get<std::string>();
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

std::string JsonNode::name() const {
  const std::string text = this->text();
  constexpr const char* allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  if (text.empty() || text.find_first_not_of(allowed) != std::string::npos)
    complain(value_->dump() + " is not a name of letters, digits, _ and -");
  return text;
}

std::string JsonNode::digest() const {
  const std::string text = this->text();
  if (text.size() != 64 || text.find_first_not_of("0123456789abcdef") != std::string::npos)
    complain(value_->dump() + " is not a SHA-256 digest");
  return text;
}

std::string JsonNode::utc() const {
  const std::string text = this->text();
  constexpr std::string_view form = "0000-00-00T00:00:00Z";
  const bool formed = std::ranges::equal(text, form, [](char c, char place) {
    return place == '0' ? '0' <= c && c <= '9' : c == place;
  });
  const auto number = [&](std::size_t first, std::size_t digits) {
    return std::stoi(text.substr(first, digits));
  };
  using namespace std::chrono;
  if (!formed || !year_month_day(year(number(0, 4)), month(number(5, 2)), day(number(8, 2))).ok() ||
      number(11, 2) > 23 || number(14, 2) > 59 || number(17, 2) > 60)  // a leap second
    complain(value_->dump() + " is not a date and time, UTC, as 2026-11-21T17:48:47Z");
  return text;
}

bool JsonNode::boolean() const {
  if (!value_->is_boolean())
    complain(std::string("true or false was expected, not ") + value_->type_name());
  return value_->get<bool>();
}

std::int64_t JsonNode::integer(std::int64_t least) const {
  if (!value_->is_number_integer())
    complain(std::string("an integer was expected, not ") + value_->type_name());
  // Compared as a double first: an unsigned integer beyond 2^63 would wrap.
  const double wide = value_->get<double>();
  if (wide < static_cast<double>(least) || wide > static_cast<double>(max_integer))
    complain(value_->dump() + " is not in " + std::to_string(least) + " ... " +
             std::to_string(max_integer));
  return value_->get<std::int64_t>();
}

double JsonNode::number() const {
  if (!value_->is_number())
    complain(std::string("a number was expected, not ") + value_->type_name());
  return value_->get<double>();
}

double JsonNode::not_negative() const {
  const double value = number();
  if (!(value >= 0)) complain(value_->dump() + " is negative");
  if (value > max_number) complain(value_->dump() + " is beyond all measure");
  return value;
}

double JsonNode::positive() const {
  const double value = not_negative();
  if (!(value > 0)) complain(value_->dump() + " is not above zero");
  return value;
}

double JsonNode::sample() const {
  const double value = positive();
  if (value < min_sample || value > max_sample)
    complain(value_->dump() + " s is not a time that a clock can give");
  return value;
}

}  // namespace desmo::report
