// Texts for people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace desmo::cli {

/// "1 body", "2 bodies"; the plural is the noun with an s unless it is given.
std::string count(long n, const std::string& noun, const std::string& plural = "");

/// "a, b, c"; when there are more than `most`, "a, b, c, … (7 more)".
std::string enumerate(const std::vector<std::string>& names, std::size_t most = 1000000);

/// Words on lines of at most 100 characters; those after the first are indented.
std::string wrap(const std::string& text, std::size_t indent);

/// Columns as wide as their widest cell, the first row being the heading; ends of lines are bare.
/// `right` has an 'r' for each column that is aligned to the right.
std::string table(const std::vector<std::vector<std::string>>& rows, std::string_view right);

}  // namespace desmo::cli
