#include "formulations/motions_ahead.h"

#include <algorithm>
#include <utility>

namespace desmo {

MotionsAhead::MotionsAhead(const PlacedMotions& placed)
    : places_(placed.places), alone_(placed), ahead_(in_order(placed.motions), together) {
  for (std::vector<double>* values : {&z_, &zd_, &zdd_}) values->resize(places_.size() * together);
}

void MotionsAhead::expect(const TimeGrid& grid) {
  grid_ = grid;
  sampled_ = 0;
  next_ = together;
}

/// Behind the last instant of the grid, that one again.
void MotionsAhead::sample_next() {
  for (int k = 0; k < together; ++k)
    times_[k] = grid_.time(std::min(sampled_ + k, grid_.instants - 1));
  ahead_(times_, z_.data(), zd_.data(), zdd_.data());
  sampled_ += together;
  next_ = 0;
}

void MotionsAhead::operator()(double t, double* z, double* zd, double* zdd) {
  if (next_ == together && sampled_ < grid_.instants) sample_next();
  if (next_ == together || times_[next_] != t) return alone_({&t, 1}, z, zd, zdd);
  for (std::size_t m = 0; m < places_.size(); ++m) {
    const std::size_t at = m * together + next_, place = places_[m];
    z[place] = z_[at];
    zd[place] = zd_[at];
    zdd[place] = zdd_[at];
  }
  ++next_;
}

}  // namespace desmo
