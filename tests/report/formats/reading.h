// Readers of the report's formats, to compare their contents. They share no code with the writers.
#pragma once

#include <string>
#include <vector>

namespace desmo::report {

/// A table as a person reads it: rows of texts, the header first. Escapes are resolved, and every
/// minus sign is a hyphen.
struct ReadTable {
  std::string title;
  std::vector<std::vector<std::string>> rows;
};

struct ReadReport {
  std::vector<ReadTable> tables;
  std::string text;  ///< the whole text, to search for paragraphs and notes
};

std::vector<std::vector<std::string>> read_csv(const std::string& text);
ReadReport read_markdown(const std::string& text);
ReadReport read_html(const std::string& text);

/// Returns a text of the report in the form that these readers return.
std::string plain(std::string text);

/// Returns the numbers in a text, in order and as written: "1.2 [-3, 4e-5]" has three.
std::vector<std::string> numbers_in(const std::string& text);

}  // namespace desmo::report
