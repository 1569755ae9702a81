#include "report/site.h"

#include <algorithm>
#include <map>

#include "report/figures/figures.h"
#include "report/formats/formats.h"
#include "report/read/record_file.h"
#include "report/report.h"
#include "report/statistics/comparability.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

namespace fs = std::filesystem;

struct NamedRecord {
  std::string name;  ///< of its file, without endings
  Record record;
};

std::vector<NamedRecord> read_records(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw UnreadableRecord(folder.string() + ": there is no folder");
  std::vector<NamedRecord> all;
  for (const auto& file : fs::directory_iterator(folder)) {
    const std::string name = file.path().filename().string();
    if (const std::size_t end = name.find(".json"); end != name.npos)
      all.push_back({name.substr(0, end), read_record(file.path())});
  }
  std::ranges::sort(all, {}, &NamedRecord::name);
  return all;
}

/// The pages so far, and the rows of the index.
struct Site {
  void add(const std::string& folder, Document document, IndexRow row) {
    document.home = "../index.html";
    std::vector<NewFile> files = figures(document);
    files.push_back({"report.html", to_html(document)});
    row.address = folder + "/report.html";
    if (row.title.empty()) row.title = document.title;
    rows.push_back(std::move(row));
    pages.push_back({folder, std::move(files)});
  }

  std::vector<SitePage> pages;
  std::vector<IndexRow> rows;
};

std::size_t rows_in(const Document& document) {
  std::size_t rows = 0;
  for (const Section& section : document.sections)
    for (const Table& table : section.tables) rows += table.rows.size();
  return rows;
}

/// Adds for every experiment of two machines the comparison that has most in common.
void add_machines(Site& site, const std::vector<NamedRecord>& records) {
  std::map<std::string, std::pair<Document, IndexRow>> best;  // by machines and experiment
  for (const auto& [first_name, a] : records)
    for (const auto& [second_name, b] : records) {
      if (a.machine.cpu >= b.machine.cpu || !different_work_reason(a, b).empty()) continue;
      Document document = make_comparison(a, b);
      for (const Experiment& experiment : experiments) {
        if (!experiment.is_in(a) || !experiment.is_in(b)) continue;
        auto& [most, row] = best[a.machine.cpu + b.machine.cpu + experiment.name];
        if (rows_in(document) <= rows_in(most)) continue;
        most = document;
        row = {
            {}, {}, a.machine.cpu + "; " + b.machine.cpu, std::max(a.date, b.date).substr(0, 10)};
        row.address = first_name + "-and-" + second_name;
      }
    }
  for (auto& [key, page] : best) {
    const std::string folder = page.second.address;
    if (std::ranges::count(site.pages, folder, &SitePage::folder) == 0)
      site.add(folder, std::move(page.first), page.second);
  }
}

}  // namespace

std::vector<SitePage> make_site(const fs::path& results) {
  Site site;
  const std::vector<NamedRecord> records = read_records(results / "records");
  for (const auto& [name, record] : records)
    site.add(name, make_report(record), {{}, {}, record.machine.cpu, record.date.substr(0, 10)});
  add_machines(site, records);
  if (const fs::path file = results / "history.json"; fs::exists(file)) {
    const History history = read_history(file);
    const std::string date = history.points.empty() ? "" : history.points.back().date.substr(0, 10);
    site.add("history", {sentence("site.history"), {history_section(history)}},
             {{}, {}, sentence("site.every_machine"), date});
  }
  site.pages.push_back({"", {{"index.html", to_index(site.rows)}}});
  return std::move(site.pages);
}

}  // namespace desmo::report
