#include "report/read/configuration.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace desmo::report {
namespace {

constexpr std::array<std::pair<std::string_view, std::string Configuration::*>, 6> settings{
    {{"guess", &Configuration::guess},
     {"jacobian", &Configuration::jacobian},
     {"factorisation", &Configuration::factorisation},
     {"scalar", &Configuration::scalar},
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

}  // namespace

bool Configuration::has_papers_settings() const {
  const Configuration paper;
  return guess == paper.guess && jacobian == paper.jacobian &&
         factorisation == paper.factorisation && scalar == paper.scalar && others.empty();
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
    const std::size_t colon = suffix.find(':');
    if (colon == 0 || colon >= suffix.size() - 1 || !keys.insert(suffix.substr(0, colon)).second)
      return std::nullopt;
    apply(configuration, suffix);
    slash = end;
  }
  if (configuration.formulation.empty()) return std::nullopt;
  return configuration;
}

}  // namespace desmo::report
