#include "report/read/configuration.h"

#include <algorithm>
#include <array>
#include <ranges>
#include <set>
#include <utility>

namespace desmo::report {
namespace {

constexpr std::array<std::pair<std::string_view, std::string Configuration::*>, 4> settings{
    {{"guess", &Configuration::guess},
     {"jacobian", &Configuration::jacobian},
     {"iterations", &Configuration::iterations},
     {"tolerance", &Configuration::tolerance}}};

/// Adds a suffix, `key:value` or a word that is no setting's key, to a configuration. Returns false
/// where the suffix is neither.
bool add(Configuration& configuration, std::string_view suffix) {
  const std::size_t colon = suffix.find(':');
  const std::string_view key = suffix.substr(0, colon);
  const auto setting = std::ranges::find(settings, key, [](const auto& s) { return s.first; });
  const bool is_setting = setting != settings.end(), has_value = colon + 1 < suffix.size();
  if (key.empty() || (colon == suffix.npos ? is_setting : !has_value)) return false;
  if (is_setting)
    configuration.*setting->second = suffix.substr(colon + 1);
  else
    configuration.others.emplace_back(suffix);
  return true;
}

}  // namespace

bool Configuration::has_papers_algorithm() const { return others.empty(); }

bool Configuration::has_papers_settings() const {
  const Configuration paper;
  return guess == paper.guess && jacobian == paper.jacobian && has_papers_algorithm();
}

bool Configuration::is_papers() const { return *this == Configuration{.formulation = formulation}; }

bool Configuration::iterates_like(const Configuration& other) const {
  return guess == other.guess && iterations == other.iterations && tolerance == other.tolerance;
}

bool Configuration::solves_every_instant() const {
  return std::ranges::none_of(others,
                              [](const std::string& o) { return o.starts_with("stride:"); });
}

std::optional<Configuration> parse_configuration(std::string_view id) {
  Configuration configuration{.formulation = std::string(id.substr(0, id.find('/')))};
  std::set<std::string_view> keys;
  for (const auto part : id | std::views::split('/') | std::views::drop(1)) {
    const std::string_view suffix(part.begin(), part.end());
    if (!add(configuration, suffix) || !keys.insert(suffix.substr(0, suffix.find(':'))).second)
      return std::nullopt;
  }
  if (configuration.formulation.empty()) return std::nullopt;
  return configuration;
}

}  // namespace desmo::report
