// The content of the report without any format: sections of paragraphs and tables.
#pragma once

#include <cstdint>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace desmo::report {

inline constexpr const char* inconclusive_mark = "inconclusive";
inline constexpr const char* missing_mark = "—";
inline constexpr const char* failed_mark = "FAILED";
inline constexpr const char* not_run_mark = "not run";
inline constexpr const char* inside_mark = "in";    ///< the paper's value is inside our interval
inline constexpr const char* outside_mark = "out";  ///< the paper's value is outside of it

/// An entry of a table: a text, or numbers with a note. The numbers in `shown` have the characters
/// of `digits`, so that Markdown and JSON have the same numbers.
struct Entry {
  // A text alone.
  Entry(std::string text) : shown(std::move(text)) {}  // NOLINT
  Entry(const char* text) : shown(text) {}             // NOLINT
  // A whole number with all its digits, such as a size or a count.
  Entry(std::int64_t number) : shown(std::to_string(number)), digits{shown} {}  // NOLINT
  Entry(std::string text, std::vector<std::string> numbers, std::string reservation)
      : shown(std::move(text)), digits(std::move(numbers)), note(std::move(reservation)) {}

  std::string shown;  ///< text for people: all of the entry
  /// Numbers in the order of Column::quantities. A missing number is "", or, at the end, left out.
  std::vector<std::string> digits;
  std::string note;  ///< text in place of a number (failed_mark ...), or a reservation about it

  bool has_number() const {
    for (const std::string& number : digits)
      if (!number.empty()) return true;
    return false;
  }
};

/// Returns the entry that shows digits in a form, then the note. Each "{}" of the form stands for
/// the next of the digits that are not empty: composed("{} [{}, {}]", {"1.2", "1.0", "1.4"}) shows
/// "1.2 [1.0, 1.4]".
Entry composed(std::string_view form, std::vector<std::string> digits, std::string note = {});

/// Returns the entry of one number.
inline Entry digits_entry(std::string digits) { return composed("{}", {std::move(digits)}); }

inline Entry note_entry(std::string note) { return {note, {}, note}; }

struct Column {
  std::string name;                     ///< unique in its table
  std::vector<std::string> quantities;  ///< names of the quantities in Entry::digits; none: texts
};

struct Table {
  /// Tells whether a figure of the table would have a mark. Marks are the entries of the column
  /// `drawn`, or else of all columns of numbers, that have numbers or a verdict (extremes) and are
  /// not the reference.
  bool has_marks() const;

  std::string name = {};   ///< lower case, unique in the document: the name of the CSV file
  std::string title = {};  ///< one line
  std::vector<std::string> notes = {};
  std::vector<Column> columns = {};
  std::vector<std::vector<Entry>> rows = {};  ///< one entry per column
  bool detail = false;       ///< left out on the terminal, which names it; folded on the page
  std::string figure = {};   ///< design of the figure drawn from the table; empty: no figure
  std::string drawn = {};    ///< column whose entries are the figure's marks; empty: all numbers
  std::string caption = {};  ///< caption of the figure: one sentence
  std::vector<std::pair<std::string, double>> lines = {};  ///< named vertical lines: name and x
};

struct Section {
  std::string title = {};
  std::vector<std::string> paragraphs = {};  ///< results in words, shown before the tables
  std::vector<Table> tables = {};
  std::string chapter = {};  ///< heading above it on the page, its experiment; empty: none
  bool front = false;  ///< it is part of the short report that a run prints, and open on the page
  std::vector<std::string> definitions = {};  ///< meanings of words and methods; folded on the page
  std::vector<std::string> numbers = {};  ///< lines in the site's index: at most three, each named
};

struct Document {
  /// Adds a section. Leaves out tables without rows, figures without marks, and a section with
  /// neither tables nor paragraphs.
  void add(Section section);

  std::string title;
  std::vector<Section> sections;
  std::string home = {};  ///< address of the site's index; empty: the page stands alone
};

/// Returns the tables of all sections of a document, in their order. The document must outlive the
/// result.
inline auto tables_of(auto& document) {
  return document.sections | std::views::transform(&Section::tables) | std::views::join;
}

}  // namespace desmo::report
