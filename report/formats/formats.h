// The formats in which a document can be written. All print Entry::shown or Entry::digits as they
// are; none rounds.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cases/io/new_files.h"
#include "report/text/document.h"

namespace desmo::report {

/// Returns a document as aligned text in UTF-8. Leaves out tables of detail and names them.
std::string to_terminal(const Document& document);

/// Returns the sections of a document that are its front, without their titles, as aligned text.
/// Lines have at most 100 characters where columns allow it.
std::string front_to_terminal(const Document& document);

/// Returns a table as CSV: RFC 4180 with "\n"; the first line is the heading. A column with
/// quantities becomes one field per quantity, named "<column> <quantity>"; where an entry has no
/// number, the first of them holds the note (FAILED, —). Where there are such columns, the last
/// field, "notes", has the reservations about numbers. A text that a spreadsheet would take for a
/// formula begins with an apostrophe.
std::string to_csv(const Table& table);

/// Returns a document as one JSON object with "title" and "sections":
/// - a section has "chapter", "title", "paragraphs", "definitions" and "tables"
/// - a table has "name", "title", "notes" and "rows"
/// - a row has a value for each column: a text, a number, or an object of quantities
/// A missing quantity is null. "note" has the text in place of a number (FAILED, —) or about it.
std::string to_json(const Document& document);

/// Returns a document as Markdown in GitHub's dialect.
std::string to_markdown(const Document& document);

/// Returns a document as a self-contained page: no script, no request to a network. In place of
/// each figure it says that the figure is missing. report/figures/render replaces what is between
/// the comments "<!-- NAME -->" and "<!-- end of NAME -->", where NAME is a figure or "scripts".
std::string to_html(const Document& document);

/// A row of a site's index: the page NAME/report.html, and Section::numbers of its first section.
struct IndexRow {
  std::string name, title, machine, date;
  std::vector<std::string> numbers;
};

/// Writes the page of a site's index, self-contained, with a selector of machine and date.
std::string to_index(const std::vector<IndexRow>& rows);

/// Returns a text in which each character that is a key of `escapes` is replaced by its value.
std::string escaped(std::string_view text, const std::map<char, std::string>& escapes);

/// Returns the number of characters of a text in UTF-8.
std::size_t characters(const std::string& text);

/// Returns the sum over columns of the number of characters of the longest entry. Headings do not
/// count.
std::size_t row_width(const Table& table);

/// Names of all formats.
inline const std::vector<std::string> format_names{"terminal", "csv", "json", "markdown", "html"};

/// Returns the files of a document in one of the formats: one file, or for csv one for each table.
/// Throws std::invalid_argument for another format.
std::vector<NewFile> render(const Document& document, const std::string& format);

/// Returns the text of a document in some formats, one after the other. In csv, several tables have
/// a blank line between them and their names in a first column, "table".
std::string printed(const Document& document, const std::vector<std::string>& formats);

}  // namespace desmo::report
