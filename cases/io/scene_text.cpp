#include "cases/io/scene_text.h"

#include <cstddef>

#include "cases/io/comments.h"

namespace desmo {

std::string with_formulation(std::string_view text, std::string_view id) {
  constexpr std::string_view key = "\"formulation\"", space = " \t\r\n";
  const std::string value = '"' + std::string(id) + '"', plain = without_comments(text);
  std::string result(text);
  // A value that is a text tells the member from other occurrences of its key. A point or a driver
  // may be called so, too, and then has a list or an object as its value.
  for (std::size_t at = plain.find(key); at != plain.npos; at = plain.find(key, at + 1)) {
    const std::size_t colon = plain.find_first_not_of(space, at + key.size());
    const std::size_t begin = plain.find_first_not_of(space, colon + 1);
    if (plain[colon] != ':' || plain[begin] != '"') continue;
    return result.replace(begin, plain.find('"', begin + 1) + 1 - begin, value);
  }
  const std::size_t last = plain.find_last_not_of(space, plain.rfind('}') - 1);
  return result.insert(last + 1, ",\n  \"formulation\": " + value);
}

}  // namespace desmo
