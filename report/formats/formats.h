// The forms in which a document can be written. All print Entry::shown or Entry::digits as they
// are; none rounds.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cases/io/new_files.h"
#include "report/text/document.h"

namespace desmo::report {

/// Aligned text for people; leaves out tables of detail and says so. UTF-8.
std::string to_terminal(const Document& document);

/// Writes the sections of a document that are its front, without titles, for the end of a run.
/// Lines have at most 100 characters where columns allow it.
std::string front_to_terminal(const Document& document);

/// RFC 4180 with "\n"; the first line is the heading. A column with quantities becomes one field
/// per quantity, named "<column> <quantity>"; where there is no number the first of them holds the
/// note (FAILED, —). Reservations about numbers are in the last field, "notes". A text that a
/// spreadsheet would take for a formula begins with an apostrophe.
std::string to_csv(const Table& table);

/// The whole report as one object: "title" and "sections", each with "chapter", "title",
/// "paragraphs" and "tables", each with "name", "title", "notes" and "rows". A row is an object by
/// column: a text or a number, or for a column with quantities an object of these, null where there
/// is none, with a "note" in place of a number (FAILED, —) or about it.
std::string to_json(const Document& document);

/// GitHub's dialect.
std::string to_markdown(const Document& document);

/// A page, self-contained: no script, no request to a network, figures missing and named. What
/// stands between the comments "<!-- NAME -->" and "<!-- end of NAME -->", NAME a figure or
/// "scripts", belongs to report/figures/render, which puts the figures there.
std::string to_html(const Document& document);

/// A page of a site, NAME/report.html, and what was found there.
struct IndexRow {
  std::string name, title, machine, date;
  std::vector<std::string> numbers;
};

/// Writes the page of a site's index, self-contained, with a selector of machine and date.
std::string to_index(const std::vector<IndexRow>& rows);

/// Replaces some characters.
std::string escaped(std::string_view text, const std::map<char, std::string>& escapes);

/// Characters of UTF-8, not bytes.
std::size_t characters(const std::string& text);

/// Characters of a row in which every entry is its column's longest: how wide a table gets.
std::size_t row_width(const Table& table);

/// Names of all formats.
inline const std::vector<std::string> format_names{"terminal", "csv", "json", "markdown", "html"};

/// The files of one format: one, or for csv one per table. The format is one of format_names.
std::vector<NewFile> render(const Document& document, const std::string& format);

/// Returns a document in some formats, one after the other. Several tables of csv have a blank line
/// between them and their names in a first column, "table".
std::string printed(const Document& document, const std::vector<std::string>& formats);

}  // namespace desmo::report
