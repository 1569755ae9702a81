// desmo_report: from records to the paper's tables and figures, and to the verdict of a check.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <list>
#include <optional>
#include <ranges>
#include <stdexcept>

#include "cases/io/new_files.h"
#include "cases/io/text_file.h"
#include "report/check/check_outcome.h"
#include "report/check/check_record.h"
#include "report/figures/figures.h"
#include "report/formats/formats.h"
#include "report/read/record.h"
#include "report/read/record_file.h"
#include "report/report.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace {

using namespace desmo;
using namespace desmo::report;

// Exit codes: below 64 the numbers of CheckVerdict, from 64 on those of sysexits.h.
enum ExitCode {
  success = 0,
  invalid = 2,
  incomparable = 4,
  usage_error = 64,
  bad_input = 65,
  not_completed = 74
};

struct TablesCommand {
  std::string record;
  std::vector<std::string> beside;
  std::string folder;                // folder for files; empty: standard output only
  std::vector<std::string> formats;  // empty: all into a folder, terminal on standard output
  std::vector<std::string> tables;   // names of tables; empty: all
  std::string history;               // file of a history; empty: none
  bool all = false;                  // print every table, not only the short report
};

/// Returns the message about a table that a report does not have. It lists the nearest tables, then
/// all. The nearest are those whose names begin as `name` does over the most letters, two or more.
std::string no_table(const std::string& name, const std::vector<std::string>& known) {
  constexpr std::size_t min_common = 2;
  const auto common = [&](const std::string& other) {
    return static_cast<std::size_t>(std::ranges::mismatch(name, other).in1 - name.begin());
  };
  std::string nearest, all;
  std::size_t longest = min_common;
  for (const std::string& other : known) longest = std::max(longest, common(other));
  for (const std::string& other : known) {
    all += (all.empty() ? "" : ", ") + other;
    if (common(other) == longest) nearest += (nearest.empty() ? "" : ", ") + other;
  }
  return "no table " + name + " in this report" +
         (nearest.empty() ? "" : "; the nearest: " + nearest) + "; there are: " + all;
}

/// Returns a document with the tables of these names only, without paragraphs and definitions. None
/// of the tables is a detail. Throws std::invalid_argument for a name that no table has.
Document with_tables(Document document, const std::vector<std::string>& names) {
  std::vector<std::string> missing = names, known;
  for (Section& section : document.sections) {
    section.paragraphs.clear();
    section.definitions.clear();
    std::erase_if(section.tables, [&](const Table& table) {
      known.push_back(table.name);
      std::erase(missing, table.name);
      return std::ranges::find(names, table.name) == names.end();
    });
    for (Table& table : section.tables) table.detail = false;
  }
  if (!missing.empty()) throw std::invalid_argument(no_table(missing.front(), known));
  std::erase_if(document.sections, [](const Section& section) { return section.tables.empty(); });
  return document;
}

ExitCode tables(const TablesCommand& command) {
  const Record record = read_record(command.record);
  if (const std::string note = note_on_version(record.version); !note.empty())
    std::cerr << "desmo_report: note: " << command.record << ": " << note << "\n";
  std::list<Record> others;
  std::vector<const Record*> beside;
  for (const std::string& file : command.beside)
    beside.push_back(&others.emplace_back(read_record(file)));
  Document document = make_report(record, beside);
  if (!command.history.empty()) {
    document.add(history_section(read_history(command.history)));
    document.sections.back().chapter = document.sections.back().title;
  }
  if (!command.tables.empty()) document = with_tables(std::move(document), command.tables);
  const auto& chosen = command.formats;
  if (command.folder.empty() && (command.all || !chosen.empty() || !command.tables.empty())) {
    write_standard_output(
        printed(document, chosen.empty() ? std::vector<std::string>{"terminal"} : chosen));
    return success;
  }
  if (command.folder.empty()) {
    write_standard_output(front_to_terminal(document) + "\n" + sentence("front.rest") + "\n");
    return success;
  }
  std::vector<NewFile> files = figures(document);
  for (const std::string& format : chosen.empty() ? format_names : chosen)
    std::ranges::move(render(document, format), std::back_inserter(files));
  write_files(command.folder, files);
  write_standard_output(command.all ? to_terminal(document) : front_to_terminal(document));
  return success;
}

struct SiteCommand {
  std::string results, folder;
};

ExitCode site(const SiteCommand& command) {
  const auto pages = make_site(command.results);
  for (const auto& [folder, files] : std::views::reverse(pages))  // the index is last: it has links
    write_files(std::filesystem::path(command.folder) / folder, files);
  return success;
}

struct CheckCommand {
  std::string file;      // results file of a check
  std::string baseline;  // results file to compare with; empty: the check holds both sides
  std::string format = "terminal";
  bool pending = false;  // list pending() measurements, one a line, in place of the verdict
};

/// Prints the verdict, or what is pending, on standard output. Returns the exit code: the number of
/// the verdict, or success after a list of what is pending.
int verdict(const CheckCommand& command) {
  const CheckRecord check = read_check(command.file);
  std::optional<CheckRecord> baseline;
  if (!command.baseline.empty()) baseline = read_check(command.baseline);
  const CheckOutcome found = compare_sides(check, baseline ? &*baseline : nullptr);
  if (command.pending) {
    std::string lines;
    for (const std::string& line : pending(found)) lines += line + "\n";
    write_standard_output(lines);
    return success;
  }
  write_standard_output(printed(verdict_document(check, found), {command.format}));
  return static_cast<int>(found.verdict);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The paper's tables and figures from records, and the verdict of a check"};
  app.set_version_flag("--version", "desmo_report " DESMO_VERSION);
  app.require_subcommand(1);
  const auto add_format = [](CLI::App* command, auto& formats) {
    command->add_option("--format", formats, "terminal, csv, json, markdown or html")
        ->check(CLI::IsMember(format_names));
  };
  TablesCommand command;
  CLI::App* tables_app = app.add_subcommand(
      "tables", "Tables 1 and 2, figures 5 and 6, time against error, and the rest");
  tables_app->add_option("record", command.record, "The record of an experiment, .json or .json.gz")
      ->required();
  tables_app->add_option("--out", command.folder,
                         "Write the files of every format, and the figures, into this folder");
  add_format(tables_app, command.formats);
  tables_app->add_option("--table", command.tables,
                         "Only the table of this name; repeatable. An unknown name lists all");
  tables_app->add_option("--beside", command.beside,
                         "Also the speed-ups of these records that other machines made");
  tables_app->add_option("--history", command.history, "Also this file of bench/check --history");
  tables_app->add_flag("--all", command.all, "Print every table, not only what stands in front");
  SiteCommand filed;
  CLI::App* site_app = app.add_subcommand("site", "A static site of all filed records");
  site_app->add_option("results", filed.results, "The folder with records/ and history.json")
      ->required();
  site_app->add_option("--out", filed.folder, "Write the site into this folder")->required();
  CheckCommand check;
  CLI::App* check_app = app.add_subcommand("check", "The verdict of a check of bench/check");
  check_app->add_option("file", check.file, "The results file")->required();
  check_app->add_option("--baseline", check.baseline, "Compare with this results file");
  add_format(check_app, check.format);
  check_app->add_flag("--pending", check.pending, "List what has still to be measured");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? success : usage_error;
  }
  const auto failed = [](const std::exception& error, ExitCode code) {
    std::cerr << "desmo_report: " << error.what() << "\n";
    return code;
  };
  const bool is_check = check_app->parsed();  // checks have other exit codes for the same errors
  try {
    if (is_check) return verdict(check);
    if (site_app->parsed()) return site(filed);
    return tables(command);
  } catch (const std::invalid_argument& error) {
    return failed(error, usage_error);
  } catch (const UnreadableFile& error) {
    return failed(error, is_check ? usage_error : bad_input);
  } catch (const MixedRecord& error) {
    return failed(error, incomparable);
  } catch (const UnsupportedVersion& error) {
    return failed(error, is_check ? incomparable : bad_input);
  } catch (const InputError& error) {
    return failed(error, is_check ? invalid : bad_input);
  } catch (const OutputError& error) {
    return failed(error, not_completed);
  }
}
