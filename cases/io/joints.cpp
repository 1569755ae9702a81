#include <algorithm>

#include "cases/io/readers.h"
#include "cases/mechanism/joint_forms.h"

namespace desmo {
namespace {

/// What others call a joint, and how it is written as a coupling.
struct CouplingName {
  std::string_view type, example;
};
constexpr CouplingName coupling_names[] = {
    {"gear", R"({"wheel1": 20, "wheel2": 40})"},
    {"rack", R"({"pinion": 15, "travel": -1})"},
    {"screw", R"({"turn": 5, "travel": -360})"},
    {"belt", R"({"pulley1": 60, "pulley2": -30})"},
};

void refuse_coupling(const JsonValue& value) {
  for (const auto& [type, example] : coupling_names)
    if (value.text() == type)
      value.complain("'" + std::string(type) +
                     "' is a coupling of coordinates and no joint; join the bodies to what carries "
                     "them, declare a coordinate of each, and give \"couplings\": {\"name\": "
                     "{\"sum\": " +
                     std::string(example) + "}}");
}

Mechanism::JointType read_type(const JsonValue& value) {
  refuse_coupling(value);
  std::vector<std::string_view> names;
  for (const JointForm& known : joint_forms())
    if (std::ranges::find(names, known.name) == names.end()) names.push_back(known.name);
  const std::string_view name = names[value.choose("type of joint", names)];
  return std::ranges::find(joint_forms(), name, &JointForm::name)->type;
}

Mechanism::Joint read_joint(const JsonValue& value, const Names& names) {
  value.allow({"name", "type", "bodies", "points", "vectors"});
  Mechanism::Joint joint;
  if (const auto name = value.find("name")) joint.name = checked_name(*name, name->text());
  joint.type = read_type(value["type"]);
  joint.bodies = names.bodies.find_pair(value["bodies"]);
  if (const auto points = value.find("points")) joint.points = names.points.find_each(*points);
  if (const auto vectors = value.find("vectors")) joint.vectors = names.vectors.find_each(*vectors);
  return joint;
}

}  // namespace

std::vector<Mechanism::Joint> read_joints(const JsonValue& root, const Names& names) {
  std::vector<Mechanism::Joint> joints;
  for (const JsonValue& value : root["joints"].elements())
    joints.push_back(read_joint(value, names));
  return joints;
}

}  // namespace desmo
