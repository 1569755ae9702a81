#include "cases/io/json_document.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>

#include "cases/io/comments.h"
#include "cases/io/input_error.h"
#include "cases/io/text_file.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

constexpr std::size_t deepest_nesting = 32;     // number of arrays and objects in one another, ≤
constexpr std::size_t max_values = 10'000'000;  // number of values in a document, ≤

std::string line_and_column(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const std::size_t line_end = before.rfind('\n');
  const std::string_view line =
      line_end == std::string_view::npos ? before : before.substr(line_end + 1);
  const auto lines = std::ranges::count(before, '\n');
  return "line " + std::to_string(lines + 1) + ", column " + std::to_string(characters(line) + 1);
}

// Returns the word or number around a position of a text, in lower case.
std::string word_at(std::string_view text, std::size_t at) {
  const auto belongs = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.';
  };
  std::size_t begin = at, end = at;
  while (begin > 0 && belongs(text[begin - 1])) --begin;
  while (end < text.size() && belongs(text[end])) ++end;
  std::string word(text.substr(begin, end - begin));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

bool is_not_finite(std::string_view word) {
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  return word == "nan" || word == "inf" || word == "infinity";
}

// Returns a message of the library, such as "[json.exception.parse_error.101] parse error at line
// 1, column 5: syntax error while parsing value - unexpected ']'; expected …", from "syntax" on.
// Leaves out the text that it read last, which can be of any length.
std::string library_message(const char* what) {
  std::string_view message = what;
  if (const auto id = message.find("] "); id != message.npos) message.remove_prefix(id + 2);
  if (message.starts_with("parse error at line"))
    message.remove_prefix(std::min(message.size(), message.find(": ") + 2));
  const auto last_read = message.find("; last read: '");
  if (last_read == message.npos) return printable(message, 200);
  const auto expected = message.rfind("'; expected ");
  std::string shortened(message.substr(0, last_read));
  if (expected != message.npos && expected > last_read) shortened += message.substr(expected + 1);
  return printable(shortened, 200);
}

std::string syntax_error(std::string_view text, std::size_t at, int library_id,
                         const char* library_what) {
  constexpr int number_overflow = 406;
  if (at >= text.size())
    return "the text ends before its value is complete; is the file truncated?";
  if (is_not_finite(word_at(text, at)))
    return "NaN and Infinity are not numbers of JSON; give a finite number";
  if (library_id == number_overflow) return "the number is too large; give one below 1e100";
  if (text[at] == '/' || text[at] == '#')
    return "is no comment; begin one with //, or write it between /* and */";
  const std::string message = library_message(library_what);
  if (message.find("UTF-8") != message.npos)
    return "the text is not UTF-8; save the file in that encoding";
  return message + "; correct the JSON there";
}

std::string pointer_token(std::string_view key) {
  return (nlohmann::json::json_pointer() / printable(key)).to_string();
}

}  // namespace

// Receiver of the events of nlohmann's parser, which adds nodes to a document. The library's own
// tree would be slow to search and, with members in the order of the file, take quadratic time to
// build.
class JsonDocument::Builder {
 public:
  Builder(JsonDocument& document, std::string_view text) : document_(document), text_(text) {}

  bool null() { return add(Kind::null); }
  bool boolean(bool value) { return add(Kind::boolean, value ? 1 : 0); }
  bool number_integer(std::int64_t value) { return add(Kind::number, static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) {
    return add(Kind::number, static_cast<double>(value));
  }
  bool number_float(double value, const std::string&) { return add(Kind::number, value); }
  bool string(const std::string& value) { return add(Kind::string, 0, store(value)); }
  bool binary(const std::vector<std::uint8_t>&) { return false; }  // JSON text has no such values

  bool start_object(std::size_t) { return open(Kind::object); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(Kind::array); }
  bool end_array() { return close(); }

  bool key(const std::string& key) {
    if (!open_.back().keys.insert(key).second)
      document_.complain(document_.pointer(open_.back().node) + pointer_token(key),
                         "the key is given twice in one object; keep one");
    key_ = store(key);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception& error) {
    const std::size_t at = std::min(position > 0 ? position - 1 : 0, text_.size());
    document_.complain(line_and_column(text_, at), syntax_error(text_, at, error.id, error.what()));
  }

 private:
  struct Open {
    std::uint32_t node;
    std::set<std::string> keys;
  };

  Span store(const std::string& text) {
    const Span span{static_cast<std::uint32_t>(document_.texts_.size()),
                    static_cast<std::uint32_t>(text.size())};
    document_.texts_ += text;
    return span;
  }

  bool add(Kind kind, double number = 0, Span text = {}) {
    std::vector<Node>& nodes = document_.nodes_;
    if (nodes.size() == max_values)
      document_.complain(
          document_.pointer(static_cast<std::uint32_t>(nodes.size() - 1)),
          "has more than " + std::to_string(max_values) + " values up to here; divide the file");
    nodes.push_back({number, text, key_, static_cast<std::uint32_t>(nodes.size() + 1), kind});
    key_ = {};
    return true;
  }

  bool open(Kind kind) {
    const auto node = static_cast<std::uint32_t>(document_.nodes_.size());
    add(kind);
    document_.nodes_.back().end = 0;
    if (open_.size() == deepest_nesting)
      document_.complain(document_.pointer(node), "is nested more than " +
                                                      std::to_string(deepest_nesting) +
                                                      " levels deep; write it flatter");
    open_.push_back({node, {}});
    return true;
  }

  bool close() {
    document_.nodes_[open_.back().node].end = static_cast<std::uint32_t>(document_.nodes_.size());
    open_.pop_back();
    return true;
  }

  JsonDocument& document_;
  std::string_view text_;
  std::vector<Open> open_;
  Span key_;  // key of the next value; empty in an array
};

JsonDocument::JsonDocument(std::string_view text, std::string file_name)
    : file_name_(std::move(file_name)) {
  if (text.size() > max_file) complain("top level", "the text is larger than 64 MiB; divide it");
  const std::string plain = without_comments(text);
  if (plain.find_first_not_of(" \t\r\n") == plain.npos)
    complain("top level", "the text is empty; give one JSON object");
  Builder builder(*this, text);
  nlohmann::json::sax_parse(plain, &builder);
  if (const auto zero = text.find('\0'); zero != text.npos)  // the library takes it for the end
    complain(line_and_column(text, zero), "a byte of value 0 is no text; leave it out");
}

JsonValue JsonDocument::root() const { return {this, 0}; }

// Goes down from the root. At each level it takes the last child that does not begin after the
// node: that child is the node, or has it inside.
std::string JsonDocument::pointer(std::uint32_t node) const {
  std::string path;
  for (std::uint32_t at = 0; at != node;) {
    std::uint32_t child = at + 1;
    std::size_t position = 0;
    for (; nodes_[child].end != 0 && nodes_[child].end <= node; ++position)
      child = nodes_[child].end;
    path += nodes_[at].kind == Kind::array ? "/" + std::to_string(position)
                                           : pointer_token(view(nodes_[child].key));
    at = child;
  }
  return path;
}

void JsonDocument::complain(const std::string& place, const std::string& what) const {
  throw InputError(printable(file_name_, 300) + ": " + (place.empty() ? "top level" : place) +
                   ": " + what);
}

}  // namespace desmo
