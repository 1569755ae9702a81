#include "formulations/verification/branch/driver_line.h"

#include <algorithm>

#include "formulations/model/scales.h"

namespace desmo {

namespace {

std::vector<double> of_drivers(const Model& m, std::span<const double> coordinates) {
  std::vector<double> result;
  for (const Driver& d : m.drivers) result.push_back(coordinates[m.entities[d.coordinate].first]);
  return result;
}

/// Returns for each driver whether a group depends on it. It does if its equations, or those of
/// groups that it needs, read the driver.
std::vector<bool> drivers_of(const Model& m, GroupId group) {
  std::vector<bool> is_needed(m.groups.size()), is_read(m.entities.size());
  is_needed[group] = true;
  const std::vector<bool> driven = independent_coordinates(m);
  for (auto c = m.constraints.rbegin(); c != m.constraints.rend(); ++c) {
    if (!is_needed[c->group]) continue;
    for (const EntityId e : c->operands) {
      is_read[e] = true;
      if (!m.entities[e].fixed && !driven[m.entities[e].first])
        is_needed[m.entities[e].group] = true;
    }
  }
  std::vector<bool> result;
  for (const Driver& d : m.drivers) result.push_back(is_read[d.coordinate]);
  return result;
}

}  // namespace

DriverLine::DriverLine(const Model& m, std::span<const double> q, std::span<const double> direction,
                       GroupId group)
    : magnitudes(of_drivers(m, nominal_magnitudes(m))),
      origin(of_drivers(m, q)),
      rates(direction.begin(), direction.end()) {
  if (group != no_position) {
    const std::vector<bool> is_needed = drivers_of(m, group);
    for (std::size_t k = 0; k < rates.size(); ++k)
      if (!is_needed[k]) magnitudes[k] = INFINITY, rates[k] = 0;
  }
  double largest = 0;
  for (std::size_t k = 0; k < rates.size(); ++k)
    largest = std::max(largest, std::abs(rates[k]) / magnitudes[k]);
  for (double& x : rates) x /= largest;
  const double length = std::sqrt(along(rates));
  for (double& x : rates) x /= length;
}

bool DriverLine::exists() const {
  return std::ranges::all_of(rates, [](double x) { return std::isfinite(x); });
}

std::ptrdiff_t DriverLine::count() const {
  return std::ranges::count_if(magnitudes, [](double x) { return x < INFINITY; });
}

double DriverLine::along(std::span<const double> change) const {
  double sum = 0;
  for (std::size_t k = 0; k < rates.size(); ++k)
    sum += change[k] / magnitudes[k] * (rates[k] / magnitudes[k]);
  return sum;
}

double DriverLine::arc(std::span<const double> z) const {
  std::vector<double> change(z.begin(), z.end());
  for (std::size_t k = 0; k < change.size(); ++k) change[k] -= origin[k];
  return along(change);
}

std::vector<double> DriverLine::at(double s) const {
  std::vector<double> z = origin;
  for (std::size_t k = 0; k < z.size(); ++k) z[k] += s * rates[k];
  return z;
}

double DriverLine::distance(std::span<const double> z, double s) const {
  double squares = 0;
  for (std::size_t k = 0; k < rates.size(); ++k) {
    const double off = (z[k] - origin[k] - s * rates[k]) / magnitudes[k];
    squares += off * off;
  }
  return std::sqrt(squares);
}

void DriverLine::lead(Model& m) const {
  for (std::size_t k = 0; k < m.drivers.size(); ++k)
    m.drivers[k].motion = Polynomial{{origin[k], rates[k]}};
}

}  // namespace desmo
