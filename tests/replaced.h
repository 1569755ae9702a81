#pragma once

#include <stdexcept>
#include <string>

namespace desmo {

/// Returns a text with another part at the first place of an old one. Throws std::logic_error where
/// it has none.
inline std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const auto at = text.find(old);
  if (at == std::string::npos)
    throw std::logic_error("the test replaces what is not there: " + old);
  return text.replace(at, old.size(), by);
}

/// Returns a text with another part at all places of an old one.
inline std::string replaced_everywhere(std::string text, const std::string& old,
                                       const std::string& by) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
    text.replace(at, old.size(), by);
  return text;
}

}  // namespace desmo
