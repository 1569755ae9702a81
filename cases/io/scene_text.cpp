#include "cases/io/scene_text.h"

#include <cstddef>

namespace desmo {

std::string with_formulation(std::string_view text, std::string_view id) {
  constexpr std::string_view key = "\"formulation\"", space = " \t\r\n";
  const std::string value = '"' + std::string(id) + '"';
  std::string result(text);
  // No other member of a scene that has this key is a text.
  for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
    const std::size_t colon = text.find_first_not_of(space, at + key.size());
    const std::size_t begin = text.find_first_not_of(space, colon + 1);
    if (text[colon] != ':' || text[begin] != '"') continue;
    return result.replace(begin, text.find('"', begin + 1) + 1 - begin, value);
  }
  const std::size_t last = text.find_last_not_of(space, text.rfind('}') - 1);
  return result.insert(last + 1, ",\n  \"formulation\": " + value);
}

}  // namespace desmo
