#include "formulations/id.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cases/mechanism/formatted.h"
#include "cases/mechanism/names.h"
#include "formulations/equations/lane_kernel.h"
#include "formulations/motion/prediction/guess.h"

namespace desmo {

namespace {

/// Returns the shortest text in scientific notation that reads back to the same number, its
/// exponent without leading zeros: 1e-6.
std::string shortest(double value) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific);
  std::string result(text.data(), end.ptr);
  const std::size_t digits = result.find('e') + 2;  // first digit of the exponent
  result.erase(digits, std::min(result.find_first_not_of('0', digits), result.size() - 1) - digits);
  return result;
}

/// A setting that ids can name, as /key:value.
struct Suffix {
  std::string_view key;
  std::string values;  ///< list of all values, for messages
  std::function<std::string(const Settings&)> print;
  /// Reads a value into the setting. Returns false when there is no such value.
  std::function<bool(std::string_view, Settings&)> parse;
};

/// Returns the suffix of a setting with named values. names: one for each enumerator, in order.
template <class Choice>
Suffix choice(std::string_view key, Choice Settings::*setting,
              const std::vector<std::string_view>& names) {
  return {
      key, joined(names),
      [=](const Settings& s) { return std::string(names[static_cast<std::size_t>(s.*setting)]); },
      [=](std::string_view text, Settings& s) {
        const auto found = std::ranges::find(names, text);
        if (found == names.end()) return false;
        s.*setting = static_cast<Choice>(found - names.begin());
        return true;
      }};
}

Suffix number(std::string_view key, std::string values, int Settings::*setting,
              const std::function<bool(int)>& is_offered) {
  return {key, std::move(values), [=](const Settings& s) { return std::to_string(s.*setting); },
          [=](std::string_view text, Settings& s) {
            return parse_number(text, s.*setting) && is_offered(s.*setting);
          }};
}

Suffix whole_number(std::string_view key, int Settings::*setting, int largest) {
  return number(key, "a whole number from 1 to " + std::to_string(largest), setting,
                [=](int n) { return n >= 1 && n <= largest; });
}

/// Returns the suffix of Settings::lanes or Settings::segments. 1 means none.
Suffix at_once(std::string_view key, int Settings::*setting) {
  return number(key, joined(lane_counts, [](int lanes) { return std::to_string(lanes); }), setting,
                [](int n) { return n == 1 || std::ranges::count(lane_counts, n) > 0; });
}

Suffix tolerance() {
  return {"tolerance", "a number above 0, such as 1e-6",
          [](const Settings& s) { return shortest(s.tolerance); },
          [](std::string_view text, Settings& s) {
            return parse_number(text, s.tolerance) && s.tolerance > 0 && std::isfinite(s.tolerance);
          }};
}

/// Returns all suffixes in the order in which they stand in an id.
const std::vector<Suffix>& suffixes() {
  static const std::vector<Suffix> all{
      choice("coordinates", &Settings::coordinates,
             {modelling_names.begin(), modelling_names.end()}),
      choice("frames", &Settings::frames, {"linearised", "exact"}),
      choice("guess", &Settings::guess, guess_names()),
      choice("jacobian", &Settings::jacobian, {"newton", "step"}),
      choice("btf", &Settings::btf, {"on", "off"}),
      at_once("lanes", &Settings::lanes),
      at_once("segments", &Settings::segments),
      whole_number("threads", &Settings::threads, max_threads),
      whole_number("stride", &Settings::stride, max_stride),
      whole_number("iterations", &Settings::fixed_iterations, max_fixed_iterations),
      tolerance()};
  return all;
}

void apply(std::string_view id, std::string_view text, std::vector<bool>& given,
           Settings& settings) {
  const std::size_t colon = text.find(':');
  for (std::size_t k = 0; k < suffixes().size(); ++k) {
    const Suffix& suffix = suffixes()[k];
    if (colon == std::string_view::npos || text.substr(0, colon) != suffix.key) continue;
    if (given[k])
      throw std::invalid_argument("formulation " + in_quotes(id) + ": '/" +
                                  std::string(suffix.key) + ":' is given twice");
    given[k] = true;
    if (suffix.parse(text.substr(colon + 1), settings)) return;
    throw std::invalid_argument("formulation " + in_quotes(id) + ": unknown value " +
                                in_quotes(text.substr(colon + 1)) + " of '/" +
                                std::string(suffix.key) + ":'; there are: " + suffix.values);
  }
  throw std::invalid_argument(
      "formulation " + in_quotes(id) + ": unknown suffix " + in_quotes("/" + std::string(text)) +
      "; there are, each followed by ':' and a value: " + joined(suffixes(), &Suffix::key));
}

}  // namespace

std::string id_with(const Variant& v, const Settings& settings) {
  std::string id = v.id;
  for (const Suffix& suffix : suffixes())
    if (const std::string value = suffix.print(settings); value != suffix.print({}))  // the default
      id += "/" + std::string(suffix.key) + ":" + value;
  return id;
}

Configuration parse_id(std::string_view id, const Settings& base) {
  std::size_t slash = std::min(id.find('/'), id.size());
  Configuration result{&find_variant(id.substr(0, slash)), base};
  std::vector<bool> given(suffixes().size());
  while (slash < id.size()) {
    const std::size_t end = std::min(id.find('/', slash + 1), id.size());
    apply(id, id.substr(slash + 1, end - slash - 1), given, result.settings);
    slash = end;
  }
  if (const std::string reason = unsupported_reason(*result.variant, result.settings);
      !reason.empty())
    throw std::invalid_argument("formulation " + in_quotes(id) + ": " + reason);
  return result;
}

}  // namespace desmo
