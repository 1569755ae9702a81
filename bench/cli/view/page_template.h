// The page of a moving mechanism, which the program carries.
#pragma once

#include <string_view>

namespace desmo::cli {

/// An HTML page, in which page_data() takes the place of "@DATA@". bundle.mjs makes it from
/// page.html while the program is built; it is empty when Node.js or a package was missing then.
extern const std::string_view page_template;

}  // namespace desmo::cli
