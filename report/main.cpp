// desmo_report: from a record to the paper's tables and figures.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "report/figures/figures.h"
#include "report/formats/formats.h"
#include "report/output_files.h"
#include "report/record_reader.h"
#include "report/report.h"

namespace {

using namespace desmo::report;

// The numbers of sysexits.h.
enum ExitCode { success = 0, usage_error = 64, invalid_data = 65, io_error = 74 };

struct TablesCommand {
  std::string record;
  std::string folder;  // empty: standard output only
  std::vector<std::string> formats;
};

std::string on_standard_output(const Document& document, const std::vector<std::string>& formats) {
  std::string text;
  for (const std::string& format : formats)
    for (const Rendered& file : render(document, format)) {
      if (format == "csv") text += (text.empty() ? "# " : "\n# ") + file.file_name + "\n";
      text += file.content;
    }
  return text;
}

void tables(const TablesCommand& command) {
  const Record record = read_record(command.record);
  const Document document = make_report(record);
  const auto& chosen = command.formats;
  if (command.folder.empty()) {
    write_standard_output(on_standard_output(
        document, chosen.empty() ? std::vector<std::string>{"terminal"} : chosen));
    return;
  }
  std::vector<Rendered> files = figures(record);
  for (const std::string& format : chosen.empty() ? format_names() : chosen)
    std::ranges::move(render(document, format), std::back_inserter(files));
  write_files(command.folder, files);
  write_standard_output(to_terminal(document));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The paper's tables and figures from a record of desmo_bench"};
  app.require_subcommand(1);
  TablesCommand command;
  CLI::App* tables_app =
      app.add_subcommand("tables", "Tables 1 and 2, figures 5 and 6, and the rest");
  tables_app->add_option("record", command.record, "The JSON record written by desmo_bench")
      ->required();
  tables_app->add_option("--out", command.folder,
                         "Write the files of every format, and the figures, into this folder");
  tables_app
      ->add_option("--format", command.formats,
                   "Only these formats: terminal, json, csv, markdown, latex, html")
      ->check(CLI::IsMember(format_names()));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? success : usage_error;
  }
  try {
    tables(command);
    return success;
  } catch (const InvalidRecord& error) {
    std::cerr << "desmo_report: " << command.record << ": " << error.what() << "\n";
    return invalid_data;
  } catch (const OutputError& error) {
    std::cerr << "desmo_report: " << error.what() << "\n";
    return io_error;
  }
}
