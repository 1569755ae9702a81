// desmo_report: from records to the paper's tables and figures, to comparisons and verdicts.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "report/check/command.h"
#include "report/comparability.h"
#include "report/comparison.h"
#include "report/figures/figures.h"
#include "report/formats/formats.h"
#include "report/output_files.h"
#include "report/record_reader.h"
#include "report/report.h"

namespace {

using namespace desmo::report;

// From 64 on, the numbers of sysexits.h.
enum ExitCode { success = 0, incomparable = 4, usage_error = 64, invalid_data = 65, io_error = 74 };

Record read_named(const std::string& file) {
  const auto named = [&file](const InvalidRecord& error) { return file + ": " + error.what(); };
  try {
    return read_record(file);
  } catch (const MixedRecord& error) {
    throw MixedRecord(named(error));
  } catch (const InvalidRecord& error) {
    throw InvalidRecord(named(error));
  }
}

struct TablesCommand {
  std::vector<std::string> records;
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

// Says why two records cannot be put beside each other; nothing when they can.
bool complain(const std::string& first, const std::string& second,
              const std::vector<Difference>& differences) {
  if (!differences.empty())
    std::cerr << "desmo_report: " << first << " and " << second << " cannot be compared:\n"
              << describe(differences);
  return !differences.empty();
}

ExitCode tables(const TablesCommand& command) {
  std::vector<Record> records;
  for (const std::string& file : command.records) {
    Record record = read_named(file);
    for (std::size_t i = 0; i < records.size(); ++i)
      if (complain(command.records[i], file, why_apart(records[i], record))) return incomparable;
    records.push_back(std::move(record));
  }
  const Document document = make_report(records);
  const auto& chosen = command.formats;
  if (command.folder.empty()) {
    write_standard_output(on_standard_output(
        document, chosen.empty() ? std::vector<std::string>{"terminal"} : chosen));
    return success;
  }
  std::vector<Rendered> files;
  for (const Record& record : records)
    std::ranges::move(figures(record), std::back_inserter(files));
  for (const std::string& format : chosen.empty() ? format_names() : chosen)
    std::ranges::move(render(document, format), std::back_inserter(files));
  write_files(command.folder, files);
  write_standard_output(to_terminal(document));
  return success;
}

struct CompareCommand {
  std::string first, second;
  std::string format = "terminal";
};

ExitCode compare(const CompareCommand& command) {
  const Record first = read_named(command.first), second = read_named(command.second);
  if (complain(command.first, command.second, why_incomparable(first, second))) return incomparable;
  write_standard_output(on_standard_output(make_comparison(first, second), {command.format}));
  return success;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The paper's tables and figures from records, comparisons and verdicts"};
  app.set_version_flag("--version", "desmo_report " DESMO_VERSION);
  app.require_subcommand(1);
  TablesCommand command;
  CLI::App* tables_app = app.add_subcommand(
      "tables", "Tables 1 and 2, figures 5 and 6, time against error, and the rest");
  tables_app
      ->add_option("records", command.records,
                   "The JSON record that an experiment of desmo_bench has written, or one of each")
      ->required();
  tables_app->add_option("--out", command.folder,
                         "Write the files of every format, and the figures, into this folder");
  tables_app
      ->add_option("--format", command.formats,
                   "Only these formats: terminal, json, csv, markdown, latex, html")
      ->check(CLI::IsMember(format_names()));
  CompareCommand comparison;
  CLI::App* compare_app =
      app.add_subcommand("compare", "How many times as fast the second record is");
  compare_app->add_option("A", comparison.first, "The first record")->required();
  compare_app->add_option("B", comparison.second, "The second record")->required();
  compare_app->add_option("--format", comparison.format, "terminal, json, csv, markdown or latex")
      ->check(CLI::IsMember(format_names()));
  CheckCommand check;
  CLI::App* check_app = app.add_subcommand("check", "The verdict of a check of bench/check");
  check_app->add_option("file", check.file, "The results file")->required();
  check_app->add_option("--baseline", check.baseline, "Compare with this results file");
  check_app->add_option("--format", check.format, "terminal, json, csv, markdown or latex")
      ->check(CLI::IsMember(format_names()));
  check_app->add_flag("--pending", check.pending, "List what has still to be measured");
  CertificateCommand certificate;
  CLI::App* certificate_app =
      app.add_subcommand("certificate", "What the trials of bench/check --certify show");
  certificate_app->add_option("file", certificate.file, "The trials")->required();
  certificate_app
      ->add_option("--format", certificate.format, "terminal, json, csv, markdown or latex")
      ->check(CLI::IsMember(format_names()));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? success : usage_error;
  }
  try {
    if (check_app->parsed()) return run(check);
    if (certificate_app->parsed()) return run(certificate);
    return compare_app->parsed() ? compare(comparison) : tables(command);
  } catch (const MixedRecord& error) {
    std::cerr << "desmo_report: " << error.what() << "\n";
    return incomparable;
  } catch (const InvalidRecord& error) {
    std::cerr << "desmo_report: " << error.what() << "\n";
    return invalid_data;
  } catch (const OutputError& error) {
    std::cerr << "desmo_report: " << error.what() << "\n";
    return io_error;
  }
}
