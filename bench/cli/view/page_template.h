// The page of a moving mechanism, which the program carries.
#pragma once

#include <string_view>

namespace desmo::cli {

/// Two HTML pages, of plane and of spatial mechanisms. PageData take the place of "@DATA@" and then
/// "@NUMBERS@" in the text. bundle.mjs makes the pages from page.html while the program is built;
/// they are empty when Node.js or a package was missing then.
struct PageTemplate {
  std::string_view planar, spatial;
};
extern const PageTemplate page_template;

}  // namespace desmo::cli
