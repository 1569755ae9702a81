#include "bench/kit/record/record_layout.h"

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>

namespace desmo::bench {

std::string record_layout(const nlohmann::ordered_json& head,
                          const nlohmann::ordered_json& sections) {
  std::string text = head.dump(1);
  text.erase(text.rfind('\n'));  // with the brace after it
  for (const auto& [name, lists] : sections.items()) {
    text += ",\n " + nlohmann::ordered_json(name).dump() + ": {";
    const char* separator = "\n  ";
    for (const auto& [list_name, list] : lists.items()) {
      text += separator + nlohmann::ordered_json(list_name).dump() + ": [";
      for (std::size_t i = 0; i < list.size(); ++i)
        text += (i == 0 ? "\n   " : ",\n   ") + list[i].dump();
      text += "\n  ]";
      separator = ",\n  ";
    }
    text += "\n }";
  }
  return text + "\n}\n";
}

double rounded(double seconds) {
  const double unit = std::pow(10, 4 - std::floor(std::log10(seconds)));
  return std::round(seconds * unit) / unit;
}

}  // namespace desmo::bench
