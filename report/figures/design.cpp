#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "report/figures/figures.h"

namespace desmo::report {

using Json = nlohmann::ordered_json;

void keep_measured(Json& spec, const std::vector<Json*>& encodings,
                   const std::set<std::string>& measured) {
  for (Json* const encoding : encodings)
    for (const auto& [channel, unknown] : {std::pair{"color", "#888888"}, {"shape", "cross"}}) {
      if (!encoding->contains(channel) || !(*encoding)[channel].contains("scale")) continue;
      Json& scale = (*encoding)[channel]["scale"];
      Json names = Json::array(), range = Json::array();
      std::set<std::string> rest = measured;
      for (std::size_t i = 0; i < scale["domain"].size(); ++i)
        if (rest.erase(scale["domain"][i].get<std::string>())) {
          names.push_back(scale["domain"][i]);
          range.push_back(scale["range"][i]);
        }
      for (const std::string& name : rest) {
        names.push_back(name);
        range.push_back(unknown);
      }
      spec["params"][0]["value"] = names;
      scale["domain"] = std::move(names);
      scale["range"] = std::move(range);
    }
}

NewFile filled_figure(const Table& table, Json spec, Json data) {
  spec["title"]["text"] = table.title;
  spec["title"]["subtitle"] = table.notes;
  spec["data"]["values"] = std::move(data);
  return {table.name + ".vl.json", spec.dump(1) + "\n"};
}

}  // namespace desmo::report
