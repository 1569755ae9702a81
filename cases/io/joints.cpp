#include <algorithm>
#include <map>
#include <set>

#include "cases/io/readers.h"
#include "cases/mechanism/joint_forms.h"

namespace desmo {
namespace {

Mechanism::JointType read_type(const JsonValue& value) {
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

// type/first body/second body, numbered from the second of these on.
class DefaultNames {
 public:
  explicit DefaultNames(const std::vector<Mechanism::Joint>& joints) {
    for (const Mechanism::Joint& joint : joints) taken_.insert(joint.name);
  }

  std::string next(const std::string& stem) {
    int& count = counts_[stem];
    std::string name;
    do {
      name = ++count == 1 ? stem : stem + "/" + std::to_string(count);
    } while (!taken_.insert(name).second);
    return name;
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> counts_;
};

}  // namespace

std::vector<Mechanism::Joint> read_joints(const JsonValue& root,
                                          const std::vector<Mechanism::Body>& bodies,
                                          const Names& names) {
  std::vector<Mechanism::Joint> joints;
  const JsonValue list = root["joints"];
  const std::vector<JsonValue> values = list.elements();
  for (const JsonValue& value : values) joints.push_back(read_joint(value, names));
  DefaultNames defaults(joints);
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints[i].name.empty())
      joints[i].name =
          defaults.next(std::string(values[i]["type"].text()) + "/" +
                        bodies[joints[i].bodies[0]].name + "/" + bodies[joints[i].bodies[1]].name);
  return joints;
}

}  // namespace desmo
