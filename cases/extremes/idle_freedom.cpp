// Row 12: a coupler between two spherical joints may spin, which moves nothing else.
#include "cases/extremes/rows.h"
#include "cases/io/files.h"

namespace desmo::extremes {

std::vector<ExtremeCase> idle_freedom(Extent) {
  ExtremeCase right{.name = "RSSR", .scene = library_scene("rssr")};
  right.bound = Bound::fixed;
  right.factor = 1e-13;
  right.idle_body = "coupler";
  return {right};
}

}  // namespace desmo::extremes
