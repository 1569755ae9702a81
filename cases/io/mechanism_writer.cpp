#include <algorithm>
#include <nlohmann/json.hpp>

#include "cases/io/files.h"
#include "cases/io/readers.h"
#include "cases/mechanism/joint_forms.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

using Json = nlohmann::ordered_json;
using Direction = Mechanism::Direction;

class Writer {
 public:
  explicit Writer(const Mechanism& mechanism) : mechanism_(mechanism) {}

  Json write() const {
    Json j = {{"format", "desmo-mechanism"}, {"version", 1}, {"name", mechanism_.name}};
    if (!mechanism_.title.empty()) j["title"] = mechanism_.title;
    j["dimension"] = mechanism_.dimension;
    if (mechanism_.length_unit != "m") j["units"] = {{"length", mechanism_.length_unit}};
    j["points"] = Json::object();
    for (const Mechanism::Point& p : mechanism_.points)
      j["points"][p.name] = components(p.position);
    if (!mechanism_.vectors.empty()) j["vectors"] = Json::object();
    for (const Mechanism::Vector& v : mechanism_.vectors)
      j["vectors"][v.name] = v.along ? Json{{"along", {point((*v.along)[0]), point((*v.along)[1])}}}
                                     : Json(components(v.direction));
    j["ground"] = body(mechanism_.bodies.front());
    j["bodies"] = Json::object();
    for (std::size_t b = 1; b < mechanism_.bodies.size(); ++b)
      j["bodies"][mechanism_.bodies[b].name] = body(mechanism_.bodies[b]);
    j["joints"] = Json::array();
    for (const Mechanism::Joint& joint : mechanism_.joints) j["joints"].push_back(write(joint));
    j["coordinates"] = Json::object();
    j["drivers"] = Json::array();
    for (const Mechanism::Coordinate& c : mechanism_.coordinates) {
      j["coordinates"][c.name] = write(c);
      if (c.driven) j["drivers"].push_back(c.name);
    }
    for (const Mechanism::Coupling& coupling : mechanism_.couplings)
      j["couplings"][coupling.name] = write(coupling);
    return j;
  }

 private:
  const std::string& point(int p) const { return mechanism_.points[p].name; }

  Json components(const Mechanism::Vec& v) const {
    Json list = Json::array();
    for (int i = 0; i < mechanism_.dimension; ++i) list.push_back(v[i]);
    return list;
  }

  Json body(const Mechanism::Body& b) const {
    Json j = Json::object();
    if (b.own) return shape(b, *b.own);
    for (const int p : b.points) j["points"].push_back(point(p));
    for (const int v : b.vectors) j["vectors"].push_back(mechanism_.vectors[v].name);
    if (b.length) j["length"] = b.length->value;
    return j;
  }

  Json shape(const Mechanism::Body& b, const Mechanism::Frame& own) const {
    Json j = {{"at", components(own.origin)}};
    for (int i = mechanism_.dimension == 2 ? 2 : 0; i < 3; ++i) j["at"].push_back(own.rotation[i]);
    for (std::size_t k = 0; k < b.points.size(); ++k)
      j["points"][point(b.points[k])] = components(Mechanism::rounded(own.points[k]));
    for (std::size_t k = 0; k < b.vectors.size(); ++k)
      j["vectors"][mechanism_.vectors[b.vectors[k]].name] =
          components(Mechanism::rounded(own.vectors[k]));
    return j;
  }

  Json write(const Mechanism::Joint& joint) const {
    Json j = Json::object();
    if (is_name(joint.name)) j["name"] = joint.name;  // a name by name_joints() may be too long
    j["type"] = std::ranges::find(joint_forms(), joint.type, &JointForm::type)->name;
    j["bodies"] = {mechanism_.bodies[joint.bodies[0]].name,
                   mechanism_.bodies[joint.bodies[1]].name};
    for (const int p : joint.points) j["points"].push_back(point(p));
    for (const int v : joint.vectors) j["vectors"].push_back(mechanism_.vectors[v].name);
    return j;
  }

  Json direction(const Direction& d) const {
    if (d.is_line()) return Json::array({point(d.from), point(d.to)});
    return mechanism_.vectors[d.vector].name;
  }

  Json write(const Mechanism::Coordinate& c) const {
    using enum Mechanism::CoordinateType;
    Json j;
    switch (c.type) {
      case angle:
        j["angle"] = direction(c.of);
        if (c.opposite)
          j["from"] = "-" + mechanism_.vectors[c.from.vector].name;
        else if (c.from.is_given())
          j["from"] = direction(c.from);
        if (c.towards.is_given()) j["towards"] = direction(c.towards);
        break;
      case distance:
      case along:
        j["distance"] = direction(c.of);
        if (c.type == along) j["along"] = mechanism_.vectors[c.vector].name;
        break;
      case component:
        j["component"] = point(c.point);
        j["axis"] = std::string(1, "xyz"[c.axis]);
    }
    if (c.estimate) j["estimate"] = *c.estimate;
    return j;
  }

  Json write(const Mechanism::Coupling& coupling) const {
    Json j;
    if (!coupling.table) {
      for (const auto& [coordinate, factor] : coupling.terms)
        j["sum"][mechanism_.coordinates[coordinate].name] = factor.value;
      return j;
    }
    const Mechanism::Coupling::Table& table = *coupling.table;
    const auto in_si = [&](const std::vector<double>& numbers, int term) {
      Json list = Json::array();
      for (const double x : numbers)
        list.push_back((Derived(x) / coupling.terms[term].factor).value);
      return list;
    };
    j["coordinate"] = mechanism_.coordinates[coupling.terms[0].coordinate].name;
    j["of"] = mechanism_.coordinates[coupling.terms[1].coordinate].name;
    j["at"] = in_si(table.arguments, 1);
    j["values"] = in_si(table.values, 0);
    j["ends"] = ends_names[static_cast<int>(table.ends)];
    j["from"] = table.from ? Json(table.from->value) : Json("drawing");
    return j;
  }

  const Mechanism& mechanism_;
};

}  // namespace

std::string write_mechanism(const Mechanism& mechanism) {
  return Writer(mechanism).write().dump(1) + "\n";
}

}  // namespace desmo
