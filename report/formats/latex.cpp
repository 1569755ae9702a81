#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "report/formats/formats.h"

namespace desmo::report {
namespace {

// A landscape page of A4 has room for so many characters.
constexpr std::size_t max_in_scriptsize = 125;

struct Replacement {
  std::string_view from;
  std::string_view to;
};

// The first that fits counts. Brackets: "\\ [" would be read as an optional argument; "--": as a
// dash where a command line was meant.
constexpr std::array<Replacement, 25> replacements{{{"\\", "\\textbackslash{}"},
                                                    {"&", "\\&"},
                                                    {"%", "\\%"},
                                                    {"$", "\\$"},
                                                    {"#", "\\#"},
                                                    {"_", "\\_"},
                                                    {"{", "\\{"},
                                                    {"}", "\\}"},
                                                    {"~", "\\textasciitilde{}"},
                                                    {"^", "\\textasciicircum{}"},
                                                    {"<", "\\textless{}"},
                                                    {">", "\\textgreater{}"},
                                                    {"|", "\\textbar{}"},
                                                    {"\"", "\\textquotedbl{}"},
                                                    {"'", "\\textquotesingle{}"},
                                                    {"`", "\\textasciigrave{}"},
                                                    {"[", "{[}"},
                                                    {"--", "-{}-{}"},
                                                    {"±", "$\\pm$"},
                                                    {"−", "$-$"},
                                                    {"–", "--"},
                                                    {"—", "---"},
                                                    {"µ", "$\\mu$"},
                                                    {"κ", "$\\kappa$"},
                                                    {"×", "$\\times$"}}};

bool starts_number(std::string_view text, std::size_t at) {
  const bool digit = at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9';
  return digit && (at == 0 || text[at - 1] == ' ' || text[at - 1] == '(' || text[at - 1] == '[');
}

std::string latex_text(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    std::string_view from = text.substr(at, 1), to = from;
    if (from == "-" && starts_number(text, at)) {
      to = "$-$";
    } else {
      for (const Replacement& replacement : replacements)
        if (text.substr(at).starts_with(replacement.from)) {
          from = replacement.from;
          to = replacement.to;
          break;
        }
    }
    result += to;
    at += from.size();
  }
  return result;
}

// Texts after the first column may need several lines: they share what a table without numbers
// leaves, or get a quarter of the page (the remarks beside numbers).
std::string layout_of(const std::vector<Column>& columns) {
  std::size_t numbers = 0;
  for (const Column& column : columns) numbers += !column.quantities.empty();
  const std::size_t percent = numbers > 0 ? 25 : 70 / std::max<std::size_t>(columns.size() - 1, 1);
  std::string layout;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool wraps = i > 0 && (numbers == 0 || i + 1 == columns.size());
    layout += !columns[i].quantities.empty() ? "r"
              : wraps                        ? "p{0." + std::to_string(percent) + "\\linewidth}"
                                             : "l";
  }
  return layout;
}

std::string latex_table(const Table& table) {
  std::string header, rows;
  const std::size_t count = table.columns.size();
  for (std::size_t i = 0; i < count; ++i)
    header += (i == 0 ? "" : " & ") + latex_text(table.columns[i].name);
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < count; ++i)
      rows += (i == 0 ? "" : " & ") + latex_text(row[i].shown);
    rows += " \\\\\n";
  }
  std::string notes;
  for (const std::string& note : table.notes)
    notes += "\n\\noindent{\\footnotesize " + latex_text(note) + "}\n";
  const std::string head = "\\hline\n" + header + " \\\\\n\\hline\n";
  const std::string size = row_width(table) > max_in_scriptsize ? "\\tiny" : "\\scriptsize";
  return "{" + size +
         "\\setlength{\\tabcolsep}{3pt}\\renewcommand{\\arraystretch}{1.2}\n"
         "\\begin{longtable}{" +
         layout_of(table.columns) + "}\n\\caption*{" + latex_text(table.title) + "}\\\\\n" + head +
         "\\endfirsthead\n" + head + "\\endhead\n" + rows + "\\hline\n\\end{longtable}}\n" + notes;
}

}  // namespace

std::string to_latex(const Document& document) {
  std::string text =
      "% " + document.title + ". For \\input, UTF-8; needs \\usepackage{longtable}, landscape.\n";
  for (const Section& section : document.sections) {
    text += "\n\\section*{" + latex_text(section.title) + "}\n";
    for (const std::string& paragraph : section.paragraphs)
      text += "\n" + latex_text(paragraph) + "\n";
    for (const Table& table : section.tables) text += "\n" + latex_table(table);
  }
  return text;
}

}  // namespace desmo::report
