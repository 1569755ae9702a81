// The page of a moving mechanism, which the program carries.
#pragma once

#include <string_view>

namespace desmo::cli {

/// Pages without their data: bundle.mjs makes them from page.html when the program is built. They
/// are empty when Node.js or a package was missing then. "@DATA@" and "@NUMBERS@" stand, in this
/// order, where PageData belong.
struct PageTemplate {
  std::string_view planar, spatial;
};
extern const PageTemplate page_template;

}  // namespace desmo::cli
