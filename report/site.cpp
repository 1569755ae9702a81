#include "report/figures/figures.h"
#include "report/formats/formats.h"
#include "report/report.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {

std::map<std::string, std::vector<NewFile>> make_site(const std::filesystem::path& results) {
  const std::filesystem::path history_file = results / "history.json";
  const std::map<std::string, Record> records = read_records(results / "records");
  std::map<std::string, std::vector<NewFile>> pages;  // files by folder
  std::vector<IndexRow> rows;
  const auto add = [&](IndexRow row, Document document) {
    document.home = "../index.html";
    row.title = document.title.substr(document.title.find(": ") + 2);
    row.numbers = document.sections.front().numbers;
    std::vector<NewFile> files = figures(document);
    files.push_back({"report.html", to_html(document)});
    rows.push_back(row);
    pages[row.name] = std::move(files);
  };
  std::vector<const Record*> all;
  for (const auto& [name, record] : records) all.push_back(&record);
  for (const auto& [name, record] : records)
    add({name, {}, record.machine.cpu, record.date.substr(0, 10), {}}, make_report(record, all));
  if (exists(history_file)) {
    const History history = read_history(history_file);
    Document document{sentence("history_section.document"), {}};
    document.add(history_section(history));
    document.sections.front().front = true;
    const std::string date = history.points.empty() ? "" : history.points.back().date;
    add({"history", {}, {}, date.substr(0, 10), {}}, std::move(document));
  }
  pages[""] = {{"index.html", to_index(rows)}};
  return pages;
}

}  // namespace desmo::report
