#include "report/figures/figures.h"

#include <cmath>
#include <set>

#include "report/text/embedded.h"
#include "tests/report/points_sample.h"
#include "tests/report/size_sample.h"

namespace desmo::report::figures_test {
namespace {

/// The specification of a figure of a record's report.
Json figure_of(const Json& record, const std::string& name) {
  for (const NewFile& file : figures(make_report(record_from(record))))
    if (file.file_name == name + ".vl.json") return Json::parse(file.content);
  ADD_FAILURE() << "no figure " << name;
  return nullptr;
}

Json find(const Json& spec, const Json& wanted) {
  for (const Json& value : spec["data"]["values"]) {
    bool found = true;
    for (const auto& [key, expected] : wanted.items()) found = found && value[key] == expected;
    if (found) return value;
  }
  return nullptr;
}

/// Two candidates, one of which is younger than the first commit and moves by 3 % at the third.
History history_sample() {
  return {{"old", "young"},
          {{"aaa", "2026-01-01T00:00:00Z", "One", "GNU", {1000, std::nullopt}},
           {"bbb", "2026-01-02T00:00:00Z", "Two", "GNU", {1019, 2000}},
           {"ccc", "2026-01-03T00:00:00Z", "Three", "GNU", {1019, 2060}}}};
}

const std::string klu = "global_automatic_klu", truck_front = "work_precision_truck_suspension";

std::vector<Document> documents() {
  std::vector<Document> all;
  const std::filesystem::path filed = DESMO_SOURCE_DIR "/results/records";
  const Record amd = read_record(filed / "amd-epyc-paper.json.gz");
  for (const char* name : {"intel-xeon-paper", "amd-epyc-extremes"})
    all.push_back(make_report(read_record(filed / (std::string(name) + ".json.gz")), {&amd}));
  for (const Json& record : {complete_record(), points_record(), sizes_record()})
    all.push_back(make_report(record_from(record)));
  all.push_back({"", {history_section(history_sample())}});
  return all;
}

/// Of all figures of all samples: every number drawn is one of the table's, every text of the hover
/// is the table's, and there is one of each.
TEST(Figures, DrawWhatTheirTablesSay) {
  std::set<std::string> seen;
  for (const Document& document : documents()) {
    std::size_t at = 0;
    const auto files = figures(document);
    for (const Section& section : document.sections)
      for (const Table& table : section.tables) {
        if (table.figure.empty()) continue;
        const NewFile& file = files.at(at++);
        EXPECT_EQ(file.file_name, table.name + ".vl.json");
        seen.insert(table.figure);
        const Json spec = Json::parse(file.content);
        EXPECT_CONTAINS(spec["$schema"].get<std::string>(), "vega-lite/v5");
        EXPECT_FALSE(spec["data"].contains("url"));
        EXPECT_EQ(spec["title"]["text"], table.title);
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
  EXPECT_EQ(seen,
            (std::set<std::string>{"extremes", "figure5", "figure6", "growth", "history", "ladder",
                                   "machines", "peers", "requests", "work_precision"}));
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
  std::string css(embedded_file("page.css"));
  std::vector<std::string> found;
  const std::string name = "--paper: ";
  for (std::size_t at = 0; (at = css.find(name, at)) != css.npos;) {
    at += name.size();
    found.push_back(css.substr(at, css.find(';', at) - at));
  }
  EXPECT_LACKS(css, "filter:");  // a colour is what it says
  return found;
}

TEST(Contrast, IsThatOfTheGuidelines) {
  EXPECT_NEAR(contrast("#fff", "#000000"), 21, 1e-12);
  EXPECT_NEAR(contrast("#777777", "#ffffff"), 4.48, 0.005);
}

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

TEST(FigureFive, ShowsOursAndThePapers) {
  Json record = complete_record();
  set_samples(record, 336, "group_symbolic_klu", {0.3, 0.1, 0.2});
  fail_candidate(record, truck, 336, "group_symbolic_lapack");
  const Json spec = figure_of(record, "figure5");
  EXPECT_EQ(spec["data"]["values"].size(), 4u * 7 * 5);
  const Json place{{"sparse solver", "klu"}, {"analysis", "TS-TPS sparse"}, {"coordinates", "336"}};
  EXPECT_EQ(find(spec, place)["seconds"], 0.2);
  EXPECT_FALSE(find(spec, place).contains("median"));  // it is the time
  const Json disturbed = find(figure_of(with_windows(record), "figure5"), place);
  EXPECT_EQ(disturbed["seconds"], 0.1);
  EXPECT_EQ(disturbed["median"], 0.2);
  const Json failed = find(
      spec, {{"sparse solver", "umfpack"}, {"analysis", "TS-TPS LAPACK"}, {"coordinates", "336"}});
  EXPECT_TRUE(failed["seconds"].is_null());
  EXPECT_EQ(failed["shown"], failed_mark);
  EXPECT_TRUE(find(spec, {{"sparse solver", "MA27 (the paper)"}, {"analysis", "FBL-TP"}})["seconds"]
                  .is_null());  // the paper gives no number
}

TEST(FigureFive, NamesTheMotionsThatDiffer) {
  Json record = complete_record();
  set_motion(record, 2);
  const Json spec = figure_of(record, "figure5");
  EXPECT_FALSE(find(spec, {{"sparse solver", "MA27 (the paper, 30 s)"}}).is_null());
  EXPECT_FALSE(find(spec, {{"sparse solver", "klu (ours, 2 s)"}}).is_null());
  EXPECT_EQ(spec["title"]["subtitle"],
            "Ours is 2 s of motion, the paper's 30 s: these times are not to be compared.");
}

TEST(FigureSix, SkipsFamiliesWithoutACellAndKeepsTheColours) {
  Json record = complete_record();
  for (const char* family : {"cholmod", "umfpack"}) erase_family(record, family);
  const Json spec = figure_of(record, "figure6");
  const Json scale = spec["layer"][0]["encoding"]["color"]["scale"];
  EXPECT_EQ(scale["domain"], Json({"MA27 (the paper)", "klu"}));
  EXPECT_EQ(scale["range"], Json({"#7a7a7a", "#d55e00"}));
  EXPECT_EQ(spec["params"][0]["value"], scale["domain"]);
  EXPECT_LT(luminance("#7a7a7a"), luminance("#d55e00"));  // in the dark, ours is the brighter
}

TEST(WorkPrecision, FamiliesKeepTheirMarksAndUnknownOnesGetACross) {
  Json json = points_record();
  json["accuracy"]["points"].push_back(solved_point("tearing_symbolic_klu", 10, 1e-9));
  const Json spec = figure_of(json, truck_front);
  const Json& encoding = spec["vconcat"][0]["layer"][0]["encoding"];
  EXPECT_EQ(encoding["color"]["scale"]["domain"],
            Json({"global, sparse", "group, sparse", "group, dense", "tearing, sparse"}));
  EXPECT_EQ(encoding["color"]["scale"]["range"],
            Json({"#7a7a7a", "#0072b2", "#0072b2", "#888888"}));
  EXPECT_EQ(encoding["shape"]["scale"]["range"], Json({"circle", "circle", "square", "cross"}));
}

TEST(WorkPrecision, TheFrontIsWhatNothingElseBeatsInBoth) {
  Json json = points_record();
  json["accuracy"]["points"].push_back(solved_point(klu + "/stride:8", 5, 1e-9));
  const Json spec = figure_of(json, truck_front);
  std::set<std::string> front;
  for (const Json& mark : spec["data"]["values"])
    if (mark["Pareto"] == "front") front.insert(mark["id"]);
  EXPECT_EQ(front, (std::set<std::string>{klu + "/guess:hermite5/jacobian:step/iterations:1",
                                          klu + "/guess:hermite5/tolerance:1e-8",
                                          klu + "/guess:hermite5", klu}));
  EXPECT_EQ(find(spec, {{"id", klu + "/stride:8"}})["family"], "interpolated");
}

// Whatever beats them, a formulation's paper settings are drawn: they are what readers know.
TEST(WorkPrecision, DrawsOfEachFormulationWhatItsOtherSettingsDoNotBeat) {
  Json json = points_record();
  const std::string lapack = "group_symbolic_lapack";
  json["accuracy"]["points"].push_back(solved_point(lapack + "/guess:linear", 95, 5e-6));
  json["accuracy"]["points"].push_back(solved_point(lapack + "/guess:quadratic", 110, 1e-15));
  const Json spec = figure_of(json, truck_front);
  EXPECT_NE(find(spec, {{"id", lapack}}), nullptr);  // "/guess:hermite5" is faster and more exact
  EXPECT_NE(find(spec, {{"id", lapack + "/guess:quadratic"}}), nullptr);
  EXPECT_EQ(find(spec, {{"id", lapack + "/guess:linear"}}), nullptr);
  EXPECT_NE(find(spec, {{"id", lapack + "/scalar:mixed"}}), nullptr);  // of another scalar
}

TEST(WorkPrecision, FailuresHaveAPanelOfTheirOwn) {
  Json json = points_record();
  const Json spec = figure_of(json, truck_front);
  ASSERT_EQ(spec["vconcat"].size(), 2u);
  const Json failed = find(spec, {{"id", "group_symbolic_lapack/scalar:float"}});
  EXPECT_EQ(failed["remark"], "no convergence at t = 0.01 s, residual 1e-06, group 'axle1/i'");
  EXPECT_TRUE(failed["µs/step"].is_null());
  point_of(json, "group_symbolic_lapack/scalar:float")["status"] = "not_applicable";
  EXPECT_EQ(figure_of(json, truck_front)["vconcat"].size(), 1u);
}

TEST(WorkPrecision, DrawsTheFloorAndThePredictedLimits) {
  Json json = points_record();
  const auto lines = [&] { return figure_of(json, truck_front)["datasets"]["lines"]; };
  ASSERT_EQ(lines().size(), 3u);
  EXPECT_EQ(lines()[0]["what"], "floor of the reference 4.0e-33");
  EXPECT_EQ(lines()[1]["what"], "κ u, double 1.1e-13");
  EXPECT_EQ(lines()[2]["at"], 6e-5);
  json["accuracy"]["floors"][0].erase("condition");
  EXPECT_EQ(lines().size(), 1u);
}

TEST(History, NamesTheCommitsInWhichACandidateMoved) {
  const Section section = history_section(history_sample());
  EXPECT_TRUE(
      section.paragraphs.at(0).starts_with("After 3 commits, 0 of 2 candidates take fewer "))
      << section.paragraphs.at(0);
  EXPECT_EQ(section.numbers.at(2), "largest rise: +3.0 %");
  const Table &lines = section.tables.at(0), &moves = section.tables.at(1);
  EXPECT_EQ(entry_at(lines, {"1"}, "young").shown, missing_mark);
  EXPECT_EQ(entry_at(lines, {"2"}, "old").shown, "1.019");
  EXPECT_EQ(entry_at(lines, {"3"}, "young").shown, "1.030 moved");
  ASSERT_EQ(moves.rows.size(), 1u);
  expect_row(moves, {"ccc"}, {{"change", "+3.0 %"}, {"before", "2000"}});
  const Json spec = Json::parse(figures({"", {section}}).at(0).content);
  EXPECT_EQ(spec["params"][0]["value"], Json({"old", "young"}));
}

TEST(Growth, DrawsTheCachesOfTheMachine) {
  const Json lines = figure_of(sizes_record(), "growth")["datasets"]["lines"];
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0]["what"], "L1 10 KiB");
  EXPECT_EQ(lines[0]["at"], 10);
  EXPECT_EQ(lines[1]["what"], "L2 100 KiB");
}

}  // namespace
}  // namespace desmo::report::figures_test
