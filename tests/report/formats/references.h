// References of a page.
#pragma once

#include <string>
#include <vector>

#include "tests/contains.h"

namespace desmo::report {

/// Returns everything that stands between two marks.
inline std::vector<std::string> texts_between(const std::string& text, const std::string& begin,
                                              const std::string& end = "\"") {
  std::vector<std::string> matches;
  for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos;) {
    at += begin.size();
    matches.push_back(text.substr(at, text.find(end, at) - at));
  }
  return matches;
}

/// Expects that a page names nothing a browser may load of its own accord; what scripts could is
/// the browser's to tell.
inline void expect_no_reference_outwards(std::string page) {
  for (std::size_t from; (from = page.find("<script")) != std::string::npos;)
    page.erase(from, page.find("</script>", from) + 9 - from);
  for (const char* attribute : {"href=\"", "src=\"", "srcset=\"", "action=\"", " data=\""})
    for (const std::string& target : texts_between(page, attribute))
      EXPECT_TRUE(target.starts_with("#") || target.starts_with("data:")) << target;
  for (const char* loader : {"@import", "<iframe", "<object", "<embed", "<base", "<form"})
    EXPECT_LACKS(page, loader) << loader;
  for (const std::string& target : texts_between(page, "url(", ")"))
    EXPECT_TRUE(target.starts_with("#")) << target;
}

}  // namespace desmo::report
