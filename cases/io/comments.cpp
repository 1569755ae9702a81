#include "cases/io/comments.h"

#include <algorithm>

namespace desmo {

std::string without_comments(std::string_view text) {
  std::string result(text);
  bool in_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (in_string && text[at] == '\\') {
      ++at;
    } else if (text[at] == '"') {
      in_string = !in_string;
    } else if (!in_string && text[at] == '/') {
      const std::string_view rest = text.substr(at);
      std::size_t size = 0;
      if (rest.starts_with("//")) size = std::min(rest.find('\n'), rest.size());
      if (rest.starts_with("/*")) size = rest.find("*/", 2) + 2;  // 1 where "*/" is missing
      if (size < 2) continue;
      std::replace_if(
          result.begin() + at, result.begin() + at + size,
          [](char c) { return c != '\n' && c != '\r' && c != '\0'; }, ' ');
      at += size - 1;
    }
  }
  return result;
}

}  // namespace desmo
