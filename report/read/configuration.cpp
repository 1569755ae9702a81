#include "report/read/configuration.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace desmo::report {
namespace {

constexpr std::array<std::pair<std::string_view, std::string Configuration::*>, 4> settings{
    {{"guess", &Configuration::guess},
     {"jacobian", &Configuration::jacobian},
     {"iterations", &Configuration::iterations},
     {"tolerance", &Configuration::tolerance}}};

void apply(Configuration& configuration, std::string_view suffix) {
  const std::size_t colon = suffix.find(':');
  for (const auto& [key, setting] : settings)
    if (suffix.substr(0, colon) == key) {
      configuration.*setting = suffix.substr(colon + 1);
      return;
    }
  configuration.others.emplace_back(suffix);
}

/// Tells whether a suffix has a key and a value, or is a word that is no key.
bool is_complete(std::string_view suffix) {
  const std::size_t colon = suffix.find(':');
  if (colon == suffix.npos)
    return !suffix.empty() && std::ranges::none_of(settings, [&](const auto& setting) {
      return setting.first == suffix;
    });
  return colon > 0 && colon + 1 < suffix.size();
}

}  // namespace

bool Configuration::has_papers_algorithm() const { return others.empty(); }

bool Configuration::has_papers_settings() const {
  const Configuration paper;
  return guess == paper.guess && jacobian == paper.jacobian && has_papers_algorithm();
}

bool Configuration::is_papers() const {
  Configuration paper;
  paper.formulation = formulation;
  return *this == paper;
}

bool Configuration::iterates_like(const Configuration& other) const {
  return guess == other.guess && iterations == other.iterations && tolerance == other.tolerance;
}

bool Configuration::solves_every_instant() const {
  return std::ranges::none_of(others,
                              [](const std::string& o) { return o.starts_with("stride:"); });
}

std::optional<Configuration> parse_configuration(std::string_view id) {
  std::size_t slash = std::min(id.find('/'), id.size());
  Configuration configuration;
  configuration.formulation = id.substr(0, slash);
  std::set<std::string_view> keys;
  while (slash < id.size()) {
    const std::size_t end = std::min(id.find('/', slash + 1), id.size());
    const std::string_view suffix = id.substr(slash + 1, end - slash - 1);
    if (!is_complete(suffix) || !keys.insert(suffix.substr(0, suffix.find(':'))).second)
      return std::nullopt;
    apply(configuration, suffix);
    slash = end;
  }
  if (configuration.formulation.empty()) return std::nullopt;
  return configuration;
}

}  // namespace desmo::report
