#include <algorithm>

#include "cases/io/readers.h"
#include "cases/mechanism/joint_forms.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

/// A coupling that other programs call a joint: its name there, an example of "sum" for angles in
/// degrees and in radians, and the meaning of the example's numbers.
struct CouplingName {
  std::string_view type, in_degrees, in_radians, meaning;
};
constexpr CouplingName coupling_names[] = {
    {"gear", R"({"wheel1": 20, "wheel2": 40})", R"({"wheel1": 20, "wheel2": 40})", "teeth"},
    {"rack", R"({"pinion": 94.24777960769379, "travel": -360})", R"({"pinion": 15, "travel": -1})",
     "a pinion of radius 15"},
    {"screw", R"({"turn": 5, "travel": -360})", R"({"turn": 5, "travel": -6.283185307179586})",
     "5 a turn"},
    {"belt", R"({"pulley1": 60, "pulley2": -30})", R"({"pulley1": 60, "pulley2": -30})", "radii"},
};

void refuse_coupling(const JsonValue& value, const DisplayUnits& units) {
  for (const auto& [type, in_degrees, in_radians, meaning] : coupling_names)
    if (value.text() == type)
      value.complain("'" + std::string(type) +
                     "' is a coupling of coordinates and no joint; join the bodies to what carries "
                     "them, declare a coordinate of each, and give \"couplings\": {\"name\": "
                     "{\"sum\": " +
                     std::string(units.angle.name == "deg" ? in_degrees : in_radians) + "}} (" +
                     std::string(meaning) + ")");
}

Mechanism::JointType read_type(const JsonValue& value, int dimension, const DisplayUnits& units) {
  refuse_coupling(value, units);
  const auto form = std::ranges::find(joint_forms(), value.text(), &JointForm::name);
  if (form != joint_forms().end()) return form->type;  // validate() checks the dimension
  std::vector<std::string_view> names;
  for (const JointForm& known : joint_forms())
    if (known.dimension == dimension) names.push_back(known.name);
  value.complain(unknown_name("type of joint", value.text(), names));
}

Mechanism::Joint read_joint(const JsonValue& value, int dimension, const DisplayUnits& units,
                            const Names& names) {
  Mechanism::Joint joint{};
  // The type is read first: a coupling's keys would otherwise be refused before its type.
  if (const auto type = value.find("type")) joint.type = read_type(*type, dimension, units);
  value.allow({"name", "type", "bodies", "points", "vectors"});
  value["type"];  // throws where the type is missing
  if (const auto name = value.find("name")) joint.name = checked_name(*name, name->text());
  joint.bodies = names.bodies.find_pair(value["bodies"]);
  if (const auto points = value.find("points")) joint.points = names.points.find_each(*points);
  if (const auto vectors = value.find("vectors")) joint.vectors = names.vectors.find_each(*vectors);
  return joint;
}

}  // namespace

std::vector<Mechanism::Joint> read_joints(const JsonValue& root, int dimension,
                                          const DisplayUnits& units, const Names& names) {
  std::vector<Mechanism::Joint> joints;
  for (const JsonValue& value : root["joints"].elements())
    joints.push_back(read_joint(value, dimension, units, names));
  return joints;
}

}  // namespace desmo
