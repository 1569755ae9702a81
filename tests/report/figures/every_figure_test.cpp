// Every figure of every sample has its table's numbers, and colours that stand out.
#include <cmath>
#include <set>

#include "report/figures/figures.h"
#include "report/text/embedded.h"
#include "tests/report/formats/references.h"
#include "tests/report/points_sample.h"
#include "tests/report/size_sample.h"

namespace desmo::report::every_figure_test {
namespace {

std::vector<Document> documents() {
  std::vector<Document> all;
  const std::filesystem::path filed = DESMO_SOURCE_DIR "/results/records";
  const Record amd = read_record(filed / "amd-epyc-paper.json.gz");
  for (const char* name : {"intel-xeon-paper", "amd-epyc-extremes"})
    all.push_back(make_report(read_record(filed / (std::string(name) + ".json.gz")), {&amd}));
  all.push_back(make_report(read_record(data_file("golden/2.1.0-others.json"))));
  for (const Json& record : {complete_record(), points_record(), sizes_record()})
    all.push_back(make_report(record_from(record)));
  all.push_back({"", {history_section(history_sample())}});
  return all;
}

/// In all figures of all samples, every number drawn is one of the table's, every text of the hover
/// is the table's, and there is one of each.
TEST(Figures, DrawWhatTheirTablesSay) {
  std::set<std::string> seen;
  for (const Document& document : documents()) {
    std::size_t at = 0;
    const auto files = figures(document);
    for (const Table& table : tables_of(document)) {
      if (table.figure.empty()) continue;
      const NewFile& file = files.at(at++);
      EXPECT_EQ(file.file_name, table.name + ".vl.json");
      seen.insert(table.figure);
      const Json spec = Json::parse(file.content);
      EXPECT_CONTAINS(spec["$schema"].get<std::string>(), "vega-lite/v5");
      EXPECT_FALSE(spec["data"].contains("url"));
      EXPECT_EQ(spec["title"]["text"], table.title);
      EXPECT_EQ(std::ranges::count(table.columns, table.drawn, &Column::name),
                !table.drawn.empty());
      EXPECT_EQ(spec["title"]["subtitle"], table.caption);
      EXPECT_TRUE(table.caption.ends_with('.')) << table.caption;  // one sentence
      EXPECT_LACKS(table.caption, ". ");
      std::multiset<std::string> drawn, printed;
      for (const Json& datum : spec["data"]["values"])
        for (const auto& [key, value] : datum.items()) {
          if (value.is_number()) drawn.insert(value.dump());
          if (key.ends_with("shown")) drawn.insert(value.get<std::string>());
        }
      for (const auto& row : table.rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
          if (table.columns[i].quantities.empty()) continue;
          printed.insert(row[i].shown);
          for (const std::string& digits : row[i].digits)
            if (!digits.empty()) printed.insert(Json::parse(digits).dump());
        }
      EXPECT_TRUE(std::ranges::includes(printed, drawn)) << table.name;
      EXPECT_FALSE(drawn.empty()) << table.name;
    }
    EXPECT_EQ(at, files.size());
  }
  EXPECT_EQ(seen, (std::set<std::string>{"extremes", "figure5", "figure6", "growth", "history",
                                         "ladder", "machines", "modelling", "peers", "requests",
                                         "work_precision"}));
}

/// Relative luminance of "#rrggbb" or "#rgb" (WCAG 2).
double luminance(std::string color) {
  if (color.size() == 4) color = {'#', color[1], color[1], color[2], color[2], color[3], color[3]};
  double sum = 0;
  for (const auto& [at, weight] : {std::pair{1, 0.2126}, {3, 0.7152}, {5, 0.0722}}) {
    const double c = std::stoi(color.substr(static_cast<std::size_t>(at), 2), nullptr, 16) / 255.0;
    sum += weight * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}

double contrast(const std::string& a, const std::string& b) {
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05) / (dark + 0.05);
}

/// Colours written in numbers, wherever in a specification but in its data.
std::set<std::string> colors_in(const Json& node) {
  std::set<std::string> colors;
  if (node.is_string() && node.get<std::string>().starts_with("#"))
    colors.insert(node.get<std::string>());
  if (node.is_structured())
    for (const auto& [key, child] : node.items())
      if (key != "values") colors.merge(colors_in(child));
  return colors;
}

/// Backgrounds of the page: in the light, in the dark, on paper.
std::vector<std::string> backgrounds() {
  const std::string css(embedded_file("page.css"));
  EXPECT_LACKS(css, "filter:");  // a colour is what it says
  return texts_between(css, "--paper: ", ";");
}

// In figure 6 ours is the brighter in the dark.
TEST(Contrast, TellsOursFromThePapers) { EXPECT_LT(luminance("#7a7a7a"), luminance("#d55e00")); }

/// Needed of graphical objects (WCAG 2, 1.4.11): every series is seen in the light and in the dark.
TEST(Figures, StandOutFromEveryBackground) {
  constexpr double min_contrast = 3;
  ASSERT_EQ(backgrounds().size(), 3u);
  for (const Document& document : documents())
    for (const NewFile& file : figures(document)) {
      const std::set<std::string> colors = colors_in(Json::parse(file.content));
      EXPECT_GT(colors.size(), 1u) << file.file_name;
      for (const std::string& color : colors)
        for (const std::string& background : backgrounds())
          EXPECT_GE(contrast(color, background), min_contrast)
              << file.file_name << ": " << color << " on " << background;
    }
}

// A record's first screen says what was found, draws it, and has its numbers for the site's index.
TEST(Documents, BeginWithASentenceAndAFigure) {
  for (const Document& document : documents()) {
    const Section& front = document.sections.front();
    SCOPED_TRACE(document.title);
    ASSERT_FALSE(front.paragraphs.empty());
    EXPECT_NE(front.paragraphs.front().find_first_of("0123456789"), std::string::npos);
    EXPECT_FALSE(front.tables.front().figure.empty());
    EXPECT_EQ(front.numbers.size(), 3u);
  }
}

}  // namespace
}  // namespace desmo::report::every_figure_test
