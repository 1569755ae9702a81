// A record of somebody who has MA27: the paper's own solver beside its stand-ins.

#include "report/figures/figures.h"
#include "report/statistics/variants.h"
#include "tests/report/sample.h"

namespace desmo::report::papers_own_test {
namespace {

/// Its candidates are those of another family at first; times as in the paper when they are set.
Json record_with_ma27() {
  Json json = complete_record();
  Json more = Json::array();
  for (Json candidate : json["paper"]["candidates"])
    if (std::string id = candidate["id"]; id.ends_with("_umfpack")) {
      candidate["id"] = id.replace(id.size() - 7, 7, papers_own);
      more.push_back(std::move(candidate));
    }
  for (Json& candidate : more) json["paper"]["candidates"].push_back(std::move(candidate));
  json["record"]["libraries"]["ma27"] = "libcoinhsl.so.2.2.5";
  return json;
}

Json with_times(Json json, const std::string& family, double global, double automatic,
                double symbolic) {
  set_family(json, "global_automatic_" + family, global);
  set_family(json, "group_automatic_" + family, automatic);
  set_family(json, "group_symbolic_" + family, symbolic);
  return json;
}

/// MA27 and UMFPACK as in the paper, KLU faster than every LAPACK variant.
Json like_the_paper() {
  Json json = record_with_ma27();
  set_family(json, "group_automatic_lapack", 2.7);
  set_family(json, "group_symbolic_lapack", 1.9);
  for (const char* family : {"ma27", "umfpack", "cholmod"})
    json = with_times(std::move(json), family, 7.1, 5.7, 3.5);
  return with_times(std::move(json), "klu", 0.5, 0.4, 0.3);
}

TEST(PapersOwn, StandsFirstAndIsComparedDirectly) {
  const Document document = make_report(record_from(like_the_paper()));
  const Table& times = table_named(document, "table1_ma27");
  EXPECT_TRUE(says(times.notes, "The paper: MA27, too, MKL's LAPACK"));
  EXPECT_FALSE(says(times.notes, "in place of"));
  EXPECT_TRUE(says(table_named(document, "table1_klu").notes, "The paper: MA27 in place of klu, "));
  EXPECT_TRUE(entry_at(times, {"558", "ours"}, "TS-G_ma27").has_number());
  const Table& figure = table_named(document, "figure6");
  ASSERT_EQ(figure.columns.size(), 6u);
  EXPECT_EQ(figure.columns[1].name, "MA27 (the paper)");
  EXPECT_EQ(figure.columns[2].name, papers_own);
  EXPECT_CONTAINS(figures(document)[0].content, "\"ma27\"");
}

TEST(PapersOwn, StandsInTheAnswer) {
  EXPECT_TRUE(says(answer(record_from(like_the_paper())).paragraphs,
                   "by the sparse solver: ma27 3.7, cholmod 3.7, umfpack 3.7, klu 0.26."));
}

TEST(PapersOwn, IsNoStandIn) {
  EXPECT_TRUE(says(limitations(record_from(record_with_ma27())).paragraphs,
                   "MA27 solves normal equations here"));
  EXPECT_TRUE(says(limitations(record_from(complete_record())).paragraphs,
                   "MA27, cannot be redistributed; cholmod, umfpack and klu stand for it"));
}

}  // namespace
}  // namespace desmo::report::papers_own_test
