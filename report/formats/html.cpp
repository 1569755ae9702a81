// The page: one file that asks the network for nothing. The place of a figure is between two
// comments, where a sentence says that it is missing; report/figures/render puts the figure there.
#include "report/formats/formats.h"
#include "report/text/embedded.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

// Largest row_width() of a table that has intervals next to their numbers, ≤. Wider tables have
// them below the numbers.
constexpr std::size_t max_row_width = 122;

std::string html_text(std::string_view text) {
  return escaped(text, {{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}});
}

std::string element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name.substr(0, name.find(' ')) + ">";
}

// Returns a note in an element whose class tells the style what it is.
std::string note_html(const std::string& note) {
  const std::string kind = note == inside_mark    ? "in"
                           : note == outside_mark ? "out"
                           : note == failed_mark  ? "failed"
                                                  : "note";
  return element("span class=\"" + kind + "\"", html_text(note));
}

// Returns a text that may break after "_" and "/". An id, which has "_" and no blank, breaks
// nowhere else.
std::string breakable(const std::string& text) {
  std::string result;
  for (const char c : html_text(text)) {
    result += c;
    if (c == '_' || c == '/') result += "<wbr>";
  }
  const bool is_id = text.find('_') != std::string::npos && text.find(' ') == std::string::npos;
  return is_id ? element("span class=\"id\"", result) : result;
}

// Returns the characters of Entry::shown, in elements: the first number, its interval or the rest,
// and the note.
std::string entry_html(const Entry& entry) {
  if (!entry.note.empty() && entry.shown == entry.note) return note_html(entry.note);
  if (!entry.has_number() || entry.digits.front().empty() ||
      !entry.shown.starts_with(entry.digits.front()))
    return breakable(entry.shown);
  std::string rest = entry.shown.substr(entry.digits.front().size()), note;
  if (!entry.note.empty() && rest.ends_with(entry.note)) {
    rest.resize(rest.size() - entry.note.size());
    note = note_html(entry.note);
  }
  const bool interval = rest.find('[') != std::string::npos ||
                        rest.find("–") != std::string::npos || rest.find("±") != std::string::npos;
  if (rest.find_first_not_of(' ') != std::string::npos)
    rest =
        element(interval ? "span class=\"rest interval\"" : "span class=\"rest\"", html_text(rest));
  return entry.digits.front() + rest + note;
}

std::string header_html(const Table& table) {
  std::string text;
  for (const Column& column : table.columns)
    text += element(column.quantities.empty() ? "th scope=\"col\"" : "th scope=\"col\" class=\"n\"",
                    breakable(column.name));
  return "<thead><tr>" + text + "</tr></thead>\n";
}

// Returns the rows. The first entry is the heading of its row; rows after one with the same first
// entry are marked as "again".
std::string rows_html(const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    const bool again = i > 0 && table.rows[i - 1].front().shown == row.front().shown;
    text += again ? "<tr class=\"again\">" : "<tr>";
    for (std::size_t j = 0; j < row.size(); ++j)
      text += element(j == 0                                ? "th scope=\"row\""
                      : table.columns[j].quantities.empty() ? "td"
                                                            : "td class=\"n\"",
                      entry_html(row[j]));
    text += "</tr>\n";
  }
  return "<tbody>\n" + text + "</tbody>\n";
}

// Returns a table in a frame of its own, in which a wide one scrolls, by keyboard too.
std::string table_html(const Table& table) {
  const std::string caption = table.name + "-caption";
  return "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-labelledby=\"" + caption +
         "\">\n<table id=\"" + table.name + (table.figure.empty() ? "" : "-data") + "\"" +
         (row_width(table) > max_row_width ? " class=\"wide\"" : "") + ">\n" +
         element("caption id=\"" + caption + "\"", element("span", html_text(table.title))) + "\n" +
         header_html(table) + rows_html(table) + "</table>\n</div>\n";
}

std::string folded(const std::string& summary, const std::string& content) {
  return "<details>\n" + element("summary", html_text(summary)) + "\n" + content + "</details>\n";
}

std::string notes_html(const Table& table) {
  std::string text;
  for (const std::string& note : table.notes) text += (text.empty() ? "" : " ") + html_text(note);
  return text.empty() ? "" : element("p class=\"notes\"", text) + "\n";
}

// Returns a figure with its title and caption above it, and its notes and data folded below it.
std::string figure_html(const Table& table) {
  const std::string& name = table.name;
  return "<figure id=\"" + name + "\">\n<figcaption>" +
         element("strong id=\"" + name + "-title\"", html_text(table.title)) + " " +
         html_text(table.caption) + "</figcaption>\n<!-- " + name +
         " -->\n<p class=\"missing\">Missing figure: " + name +
         ". report/figures/render draws it and needs Node.js; its numbers are in the table.</p>\n"
         "<!-- end of " +
         name + " -->\n" +
         folded("Notes, and the figure’s data as a table", notes_html(table) + table_html(table)) +
         "</figure>\n";
}

std::string block_html(const Table& table) {
  if (!table.figure.empty()) return figure_html(table);
  const std::string content = table_html(table) + notes_html(table);
  return table.detail ? folded(table.title, content) : content;
}

std::string paragraphs_html(const std::vector<std::string>& paragraphs, bool is_list) {
  std::string text;
  for (const std::string& paragraph : paragraphs)
    text += element(is_list ? "li" : "p", html_text(paragraph)) + "\n";
  return is_list ? element("ul", "\n" + text) + "\n" : text;
}

std::string definitions_html(const Section& section) {
  if (section.definitions.empty()) return {};
  return folded("What the words mean, and how it was measured",
                paragraphs_html(section.definitions, false));
}

// Returns the section in front, which is not folded: its words, figures, then tables.
std::string front_html(const Section& section, const std::string& id) {
  std::string figures, tables;
  for (const Table& table : section.tables)
    (table.figure.empty() ? tables : figures) += block_html(table);
  return "<section class=\"front\" id=\"" + id + "\" aria-labelledby=\"" + id +
         "-title\">\n<div class=\"words\">\n" +
         element("h2 id=\"" + id + "-title\"", html_text(section.title)) + "\n" +
         paragraphs_html(section.paragraphs, false) + "</div>\n" + figures +
         "<div class=\"more\">\n" + tables + definitions_html(section) + "</div>\n</section>\n";
}

// Returns a section folded under its title, open where it is in front. Two or more paragraphs
// without tables are a list: limitations, failures.
std::string section_html(const Section& section, const std::string& id) {
  std::string tables;
  for (const Table& table : section.tables) tables += block_html(table);
  return "<details class=\"section\" id=\"" + id + "\"" + (section.front ? " open" : "") +
         ">\n<summary>" + element("h3", html_text(section.title)) + "</summary>\n" +
         paragraphs_html(section.paragraphs,
                         section.tables.empty() && section.paragraphs.size() > 1) +
         tables + definitions_html(section) + "</details>\n";
}

std::string sections_html(const Document& document) {
  std::string text, chapter;
  for (std::size_t i = 0; i < document.sections.size(); ++i) {
    const Section& section = document.sections[i];
    const std::string id = "section-" + std::to_string(i + 1);
    if (i == 0 && section.front) {
      text += front_html(section, id);
      continue;
    }
    if (section.chapter != chapter) text += element("h2", html_text(section.chapter)) + "\n";
    chapter = section.chapter;
    text += section_html(section, id);
  }
  return text;
}

}  // namespace

std::string to_html(const Document& document) {
  return filled(
      embedded_file("page.template.html"),
      {{"title", html_text(document.title)},
       {"style", embedded_file("page.css")},
       {"home", document.home.empty() ? "" : "<a href=\"" + document.home + "\">All records</a>"},
       {"sections", sections_html(document)}});
}

std::string to_index(const std::vector<IndexRow>& rows) {
  std::string text;
  for (const auto& [name, title, machine, date, numbers] : rows) {
    std::string found;
    for (const std::string& number : numbers) found += element("li", html_text(number));
    text += "<tr><th scope=\"row\"><a href=\"" + html_text(name) + "/report.html\">" +
            html_text(title) + "</a> " + element("span class=\"rest\"", html_text(name)) + "</th>" +
            element("td", html_text(machine)) + element("td class=\"n\"", html_text(date)) +
            element("td", element("ul", found)) + "</tr>\n";
  }
  return filled(embedded_file("index.template.html"), {{"style", embedded_file("page.css")},
                                                       {"rows", text},
                                                       {"script", embedded_file("index.js")}});
}

}  // namespace desmo::report
