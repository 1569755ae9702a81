// The report's formats read back, without a line of the code that writes them: for comparing what
// they say.
#pragma once

#include <string>
#include <vector>

namespace desmo::report {

/// Rows of texts as a reader sees them, the header first; escapes undone and every minus a hyphen.
struct ReadTable {
  std::string title;
  std::vector<std::vector<std::string>> rows;
};

struct ReadReport {
  std::vector<ReadTable> tables;
  std::string text;  ///< all of it, for looking up paragraphs and notes
};

std::vector<std::vector<std::string>> read_csv(const std::string& text);
ReadReport read_markdown(const std::string& text);
ReadReport read_html(const std::string& text);

/// A text of the report as the readers above give it.
std::string plain(std::string text);

/// The numbers in a text, in order, as they are written: "1.2 [-3, 4e-5]" has three.
std::vector<std::string> numbers_in(const std::string& text);

}  // namespace desmo::report
