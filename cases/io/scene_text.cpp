#include "cases/io/scene_text.h"

#include <algorithm>
#include <cstddef>

namespace desmo {

namespace {

/// Walks through JSON that is known to be right.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  char next() const { return text_[at_]; }
  void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  void skip_character() { ++at_; }

  void skip_string() {
    for (++at_; text_[at_] != '"'; ++at_)
      if (text_[at_] == '\\') ++at_;
    ++at_;
  }

  void skip_value() {
    int depth = 0;
    do {
      const char c = next();
      if (c == '"') {
        skip_string();
        continue;
      }
      if (c == '{' || c == '[') ++depth;
      if (c == '}' || c == ']') --depth;
      at_ = depth > 0 || c == '}' || c == ']'
                ? at_ + 1
                : std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
    } while (depth > 0);
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::string with_formulation(std::string_view text, std::string_view id) {
  const std::string value = '"' + std::string(id) + '"';
  Scanner scanner(text);
  scanner.skip_space();
  std::size_t end_of_last = 0;
  do {
    scanner.skip_character();  // { or ,
    scanner.skip_space();
    const std::size_t key = scanner.at();
    scanner.skip_string();
    const bool is_formulation = text.substr(key, scanner.at() - key) == "\"formulation\"";
    scanner.skip_space();
    scanner.skip_character();  // :
    scanner.skip_space();
    const std::size_t begin = scanner.at();
    scanner.skip_value();
    end_of_last = scanner.at();
    if (is_formulation)
      return std::string(text.substr(0, begin)) + value + std::string(text.substr(end_of_last));
    scanner.skip_space();
  } while (scanner.next() == ',');
  return std::string(text.substr(0, end_of_last)) + ",\n  \"formulation\": " + value +
         std::string(text.substr(end_of_last));
}

}  // namespace desmo
