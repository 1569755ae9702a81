#include <algorithm>
#include <optional>

#include "cases/numbers/space.h"
#include "formulations/modelling/equations/equation_writer.h"
#include "formulations/modelling/frames/axes.h"

namespace desmo {

namespace {

bool leaves_its_plane(const Mechanism& d, const RigidBody& body, double reach) {
  const auto& directions = body.basis.directions;
  if (directions.size() != 2) return false;
  const BodyDrawing<double> drawing{d};
  nominal::Vec normal =
      cross(drawing.direction(body, directions[0]), drawing.direction(body, directions[1]));
  const double length = nominal::norm(normal);
  for (double& x : normal) x /= length;
  const auto is_off = [&](const Mechanism::Direction& direction, double magnitude) {
    return !is_rounding(dot(normal, drawing.direction(body, direction)), magnitude);
  };
  reach = reach_of(d, body, reach);
  return std::ranges::any_of(body.points,
                             [&](int p) {
                               return is_off({-1, body.basis.origin, p}, reach);
                             }) ||
         std::ranges::any_of(body.vectors, [&](int v) {
           return !follows_from_points(d, body, v) && is_off({v}, 1);
         });
}

}  // namespace

std::optional<FramedMechanism> with_plane_normals(const Mechanism& d, const RigidBodies& rigid) {
  if (d.dimension == 2) return {};
  const double reach = reach_of(d);
  std::optional<FramedMechanism> result;
  for (int r = 1; r < static_cast<int>(rigid.list.size()); ++r) {
    if (!leaves_its_plane(d, rigid.list[r], reach)) continue;
    if (!result) {
      result.emplace();
      result->mechanism = d;
      result->rigid = rigid;
    }
    AxisMaker(*result).add_normal(r);
  }
  return result;
}

}  // namespace desmo
