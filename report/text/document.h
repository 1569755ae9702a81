// The report's content, before it takes the form of a format: sections of paragraphs and tables.
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
inline constexpr const char* inside_mark = "in";  ///< the paper's value, of our interval
inline constexpr const char* outside_mark = "out";

/// A place in a table. `shown` is composed of `digits` and `note` and nothing else, so that a
/// reader of the Markdown and a program reading the JSON see the same numbers.
struct Entry {
  // A text alone, as rows are mostly written.
  Entry(std::string text) : shown(std::move(text)) {}  // NOLINT
  Entry(const char* text) : shown(text) {}             // NOLINT
  // A whole number, in full: a size, or how many things there are.
  Entry(std::int64_t number) : shown(std::to_string(number)), digits{shown} {}  // NOLINT
  Entry(std::string text, std::vector<std::string> numbers, std::string reservation)
      : shown(std::move(text)), digits(std::move(numbers)), note(std::move(reservation)) {}

  std::string shown;                ///< terminal, Markdown
  std::vector<std::string> digits;  ///< one per Column::quantities, "" where there is none
  std::string note;  ///< in place of a number (failed_mark ...) or a reservation about it

  bool has_number() const {
    for (const std::string& number : digits)
      if (!number.empty()) return true;
    return false;
  }
};

/// Shows digits in a form: each "{}" is the next of them that is not empty; then the note.
/// composed("{} [{}, {}]", {"1.2", "1.0", "1.4"}) is "1.2 [1.0, 1.4]"
Entry composed(std::string_view form, std::vector<std::string> digits, std::string note = {});

/// Shows digits, the only quantity.
inline Entry digits_entry(std::string digits) { return composed("{}", {std::move(digits)}); }

inline Entry note_entry(std::string note) { return {note, {}, note}; }

struct Column {
  std::string name;                     ///< unique in its table
  std::vector<std::string> quantities;  ///< names of what an entry's digits mean; none: text
};

struct Table {
  /// Tells whether a figure of the table would have a mark: a number or a verdict of `drawn`.
  bool has_marks() const;

  std::string name = {};   ///< lower case, unique in the document: the name of the CSV file
  std::string title = {};  ///< one line
  std::vector<std::string> notes = {};
  std::vector<Column> columns = {};
  std::vector<std::vector<Entry>> rows = {};  ///< one entry per column
  bool detail = false;      ///< left out on the terminal, which says so; folded on the page
  std::string figure = {};  ///< the design of the figure `name` drawn from it, above it on the page
  std::string drawn = {};   ///< the column whose entries are the figure's marks; empty: all numbers
  std::string caption = {};                                ///< of the figure: one sentence
  std::vector<std::pair<std::string, double>> lines = {};  ///< of the figure: names and values
};

struct Section {
  std::string title = {};
  std::vector<std::string> paragraphs = {};  ///< what was found: shown first
  std::vector<Table> tables = {};
  std::string chapter = {};  ///< the experiment it belongs to; empty: no heading of its own
  bool front = false;        ///< it is shown on the terminal, and first on the page
  std::vector<std::string> definitions = {};  ///< of words and methods: on the page folded, last
  std::vector<std::string> numbers = {};  ///< what the site's index says of it: three, each named
};

struct Document {
  /// Adds a section. Leaves out tables without rows, figures without marks, and a section with
  /// neither tables nor paragraphs.
  void add(Section section);

  std::string title;
  std::vector<Section> sections;
  std::string home = {};  ///< address of the site's index; empty: the page stands alone
};

/// Returns the tables of all sections of a document, which it refers to, in their order.
inline auto tables_of(auto& document) {
  return document.sections | std::views::transform(&Section::tables) | std::views::join;
}

}  // namespace desmo::report
