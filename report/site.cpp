#include "report/site.h"

#include <algorithm>

#include "report/figures/figures.h"
#include "report/formats/formats.h"
#include "report/read/record_file.h"
#include "report/report.h"
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
  void add(const IndexRow& row, Document document) {
    document.home = "../index.html";
    std::vector<NewFile> files = figures(document);
    files.push_back({"report.html", to_html(document)});
    rows.push_back(row);
    pages.push_back({row.name, std::move(files)});
  }

  std::vector<SitePage> pages;
  std::vector<IndexRow> rows;
};

}  // namespace

std::vector<SitePage> make_site(const fs::path& results) {
  Site site;
  const std::vector<NamedRecord> records = read_records(results / "records");
  std::vector<const Record*> all;
  for (const NamedRecord& named : records) all.push_back(&named.record);
  for (const auto& [name, record] : records)
    site.add({name, record.machine.cpu, record.date.substr(0, 10)}, make_report({&record}, all));
  if (const fs::path file = results / "history.json"; fs::exists(file)) {
    const History history = read_history(file);
    site.add(
        {"history", "", history.points.empty() ? "" : history.points.back().date.substr(0, 10)},
        {sentence("history_section.document"), {history_section(history)}});
  }
  site.pages.push_back({"", {{"index.html", to_index(site.rows)}}});
  return std::move(site.pages);
}

}  // namespace desmo::report
