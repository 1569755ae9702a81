#include "report/figures/figures.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "report/digits.h"
#include "report/embedded.h"
#include "report/measurements.h"
#include "report/paper.h"
#include "report/variants.h"

namespace desmo::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* paper_panel = "MA27 (the paper)";

// Panels of figure 5: with the durations when the motions are not the same.
struct Panels {
  std::string paper;
  std::vector<std::pair<std::string_view, std::string>> ours;  // family and its panel
};

Panels panels(const Record& record) {
  const Sources source = sources(record);
  const bool same = source.warning.empty();
  Panels result{same ? paper_panel : "MA27 (the " + source.paper + ")", {}};
  for (const std::string_view family : recorded_families(record))
    result.ours.emplace_back(family, std::string(family) + (same ? "" : " (" + source.ours + ")"));
  return result;
}

// What stands under the same line of the legend in every panel: TS-TPA_MA27 -> TS-TPA sparse.
std::string legend(const Variant& variant) {
  std::string name = family_name(variant, "sparse");
  for (char& c : name)
    if (c == '_') c = ' ';
  return name.ends_with("LAP") ? name + "ACK" : name;
}

// The number that the tables print, and no other.
Json shown(double value, DigitStyle style) { return Json::parse(write(value, style)); }

Json time_point(const Record& record, const Variant& variant, std::int64_t size,
                std::string_view family, const std::string& panel) {
  Json point{{"panel", panel}, {"analysis", legend(variant)}, {"coordinates", size}};
  const Measured time = measured(record, family_key(variant, size, family));
  if (!time.seconds) return point.update({{"seconds", nullptr}, {"note", time.mark}}), point;
  const DigitStyle style = significant_digits(time.seconds->median, 4);
  point["seconds"] = shown(time.seconds->median, style);
  point["least"] = shown(time.seconds->least, style);
  point["largest"] = shown(time.seconds->largest, style);
  return point;
}

Json time_points(const Record& record) {
  const Panels panel = panels(record);
  Json points = Json::array();
  for (const Variant& variant : variants)
    for (const std::int64_t size : published_sizes())
      if (const auto seconds =
              published_cpu_seconds().number(std::to_string(size), variant.paper_name))
        points.push_back({{"panel", panel.paper},
                          {"analysis", legend(variant)},
                          {"coordinates", size},
                          {"seconds", *seconds}});
  for (const auto& [family, name] : panel.ours)
    for (const Variant& variant : variants)
      for (const std::int64_t size : published_sizes())
        points.push_back(time_point(record, variant, size, family, name));
  return points;
}

Json speed_up_bar(const Record& record, std::size_t variant, std::string_view family) {
  const std::vector<std::int64_t>& sizes = published_sizes();
  const MeanSpeedUp mean = mean_speed_up(record, family, truck_global, variant, sizes);
  Json bar{{"solver", family}, {"variant", legend(variants[variant])}};
  if (!mean.speed_up) return bar.update({{"speed_up", nullptr}, {"label", "n/a"}}), bar;
  const DigitStyle style = ratio_digits(mean.speed_up->value);
  const std::string digits = write(mean.speed_up->value, style);
  bar["speed_up"] = Json::parse(digits);
  bar["label"] = mean.sizes == sizes.size() ? digits : digits + "*";
  if (mean.speed_up->spread) {
    bar["low"] = shown(mean.speed_up->low, style);
    bar["high"] = shown(mean.speed_up->high, style);
  }
  return bar;
}

Json speed_up_bars(const Record& record) {
  Json bars = Json::array();
  for (const std::size_t variant : topological) {
    const std::string digits = published_speed_up().text("mean", variants[variant].paper_name);
    bars.push_back({{"solver", paper_panel},
                    {"variant", legend(variants[variant])},
                    {"speed_up", Json::parse(digits)},
                    {"label", digits}});
    for (const std::string_view family : recorded_families(record))
      bars.push_back(speed_up_bar(record, variant, family));
  }
  return bars;
}

// The order of the panels; the design knows those of equal motions only.
Json design_of_times(const Record& record) {
  Json spec = Json::parse(embedded::figure5);
  const Panels panel = panels(record);
  Json order = Json::array({panel.paper});
  for (const auto& [family, name] : panel.ours) order.push_back(name);
  spec["facet"]["sort"] = std::move(order);
  return spec;
}

// No line in the legend for a family that was not recorded; the others keep their colours.
Json design_of_speed_ups(const Record& record) {
  Json spec = Json::parse(embedded::figure6);
  const std::vector<std::string_view> families = recorded_families(record);
  Json& scale = spec["layer"][0]["encoding"]["color"]["scale"];
  Json domain = Json::array(), range = Json::array();
  for (std::size_t i = 0; i < scale["domain"].size(); ++i) {
    const std::string solver = scale["domain"][i];
    if (solver != paper_panel &&
        std::find(families.begin(), families.end(), solver) == families.end())
      continue;
    domain.push_back(solver);
    range.push_back(scale["range"][i]);
  }
  scale["domain"] = domain;
  scale["range"] = range;
  spec["encoding"]["xOffset"]["sort"] = domain;
  return spec;
}

Rendered filled(const std::string& name, Json spec, Json data,
                const std::vector<std::string>& subtitle) {
  spec["title"]["subtitle"] = subtitle;
  spec["data"] = {{"values", std::move(data)}};
  return {name, spec.dump(1) + "\n"};
}

}  // namespace

std::vector<Rendered> figures(const Record& record) {
  const std::string place = "Ours: " + record.machine.cpu + ", " + record.date + ".";
  const Sources source = sources(record);
  const std::string duration = write_shortest(record.settings.duration_seconds) + " s of motion";
  std::vector<std::string> times{place, "CPU time of " + duration + ": median of " +
                                            repetitions(record) +
                                            ", bars from smallest to largest."};
  if (!source.warning.empty()) times.push_back(source.warning);
  times.insert(times.end(),
               {"The paper: Intel Core i5-2400; its FBL-TP, below 0.015 s, has no points.",
                "Dashed: four-bar (FBL); solid: truck suspension (TS). Each panel has its own "
                "time axis; a gap: failed or not measured."});
  std::vector<std::string> ratios{
      place,
      "Ratio of the medians of " + repetitions(record) + ", mean of five sizes (* of fewer),",
      "with its interval.",
      "The same sparse solver stands in the columns named sparse and in the global "
      "reference."};
  if (!source.ratio_warning.empty()) ratios.push_back(source.ratio_warning);
  return {filled("figure5.vl.json", design_of_times(record), time_points(record), times),
          filled("figure6.vl.json", design_of_speed_ups(record), speed_up_bars(record), ratios)};
}

}  // namespace desmo::report
