#include "tests/fuzz/grammar.h"

#include <fstream>
#include <map>
#include <vector>

#include "cases/mechanism/joint_forms.h"

namespace desmo::fuzz {
namespace {

using Pointer = Json::json_pointer;

Pointer any_child(const Pointer& at, const Json& container, Random& random) {
  if (!container.is_structured() || container.empty()) throw NothingToPick();
  const std::size_t i = random.below(container.size());
  return container.is_array()
             ? at / i
             : at / std::next(container.begin(), static_cast<std::ptrdiff_t>(i)).key();
}

void collect(const Json& value, const Pointer& at, std::string_view type,
             std::vector<Pointer>& all) {
  if (type.empty() || type == value.type_name()) all.push_back(at);
  for (const auto& [key, inner] : value.items())
    if (value.is_array())
      collect(inner, at / std::stoul(key), type, all);
    else if (value.is_object())
      collect(inner, at / key, type, all);
}

/// Returns the places of values of a type, parents first; of all types where it is empty.
std::vector<Pointer> places(const Json& root, std::string_view type = {}) {
  std::vector<Pointer> all;
  collect(root, Pointer(), type, all);
  return all;
}

/// The values that stand for placeholders in one patch.
class Expansion {
 public:
  Expansion(const Json& rules, Json& root, Random& random)
      : rules_(rules), root_(root), random_(random) {}

  Json value(const Json& pattern) {
    Json result = pattern;
    if (pattern.is_string() && pattern.get_ref<const std::string&>().starts_with('$'))
      return bound(pattern, [&](std::string_view rule) { return drawn(rule); });
    if (pattern.is_array()) {
      result.clear();
      for (const Json& element : pattern) append(result, element);
    } else if (pattern.is_object()) {
      result.clear();
      for (const auto& [key, member] : pattern.items())
        if (!key.ends_with('?'))
          result[key] = value(member);
        else if (random_.one_in(2))
          result[key.substr(0, key.size() - 1)] = value(member);
    }
    return result;
  }

  std::string place(std::string_view pattern) {
    Pointer at;
    while (!pattern.empty()) {
      const std::size_t end = std::min(pattern.find('/', 1), pattern.size());
      const std::string segment(pattern.substr(1, end - 1));
      pattern.remove_prefix(end);
      if (segment == "mechanism" && !root_.contains(segment)) continue;
      if (segment.starts_with("**"))
        at = Pointer(bound(segment, [&](std::string_view any) {
          const std::vector<Pointer> all = places(root_, any.substr(2));
          return Json(random_.pick(all).to_string());
        }));
      else if (segment.starts_with('*'))
        at = Pointer(bound(at.to_string() + segment, [&](std::string_view) {
          return Json(any_child(at, root_.at(at), random_).to_string());
        }));
      else
        at /= value(segment).get<std::string>();
    }
    return at.to_string();
  }

 private:
  /// Draws a value, or returns that of the same `name:x` before.
  template <class Draw>
  Json bound(const std::string& name, Draw draw) {
    const std::size_t colon = name.find(':');
    if (colon == name.npos) return draw(std::string_view(name));
    const auto known = bound_.find(name);
    if (known != bound_.end()) return known->second;
    return bound_[name] = draw(std::string_view(name).substr(0, colon));
  }

  void append(Json& list, const Json& element) {
    const std::string text = element.is_string() ? element.get<std::string>() : "";
    if (!text.starts_with('$') || !text.ends_with('*')) return list.push_back(value(element));
    // More than a file may list, too.
    std::size_t count = random_.one_in(12) ? 95 + random_.below(10) : random_.below(5);
    for (; count > 0; --count) list.push_back(value(text.substr(0, text.size() - 1)));
  }

  Json drawn(std::string_view rule) {
    rule.remove_prefix(1);
    for (const auto& [name, member] : {std::pair{"point", "points"},
                                       {"vector", "vectors"},
                                       {"mobile", "bodies"},
                                       {"coordinate", "coordinates"}})
      if (rule == name) return name_in(mechanism_in(root_), member);
    if (rule == "new") return "n" + std::to_string(random_.below(1000));
    if (rule == "joint") return joint_forms()[random_.below(joint_forms().size())].name;
    if (rule == "around") return 3 * random_.uniform(-1, 1);
    if (rule == "long")
      return "raw:" + std::string(random_.one_in(2) ? "1" : "0.") + std::string(400, '0');
    return value(random_.pick(rules_.at(rule)));
  }

  Json name_in(Json* mechanism, const char* member) {
    if (!mechanism) throw NothingToPick();
    return any_child(Pointer(), mechanism->at(member), random_).back();
  }

  const Json& rules_;
  Json& root_;
  Random& random_;
  std::map<std::string, Json> bound_;
};

}  // namespace

std::string write(const Json& document) {
  std::string text = document.dump(1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find("\"raw:", at)) != text.npos;) {
    text.erase(std::min(text.find('"', at + 1), text.size() - 1), 1);
    text.erase(at, 5);
  }
  return text;
}

Json* mechanism_in(Json& root) {
  if (!root.is_object()) return nullptr;
  Json& found = root.contains("mechanism") ? root["mechanism"] : root;
  return found.is_object() ? &found : nullptr;
}

Grammar::Grammar(const std::filesystem::path& file) : file_(Json::parse(std::ifstream(file))) {}

void Grammar::patch(Json& root, std::string_view list, Random& random) const {
  Expansion expansion(file_.at("rules"), root, random);
  for (Json operation : random.pick(file_.at(list))) {
    for (const char* member : {"from", "path"})
      if (operation.contains(member))
        operation[member] = expansion.place(operation[member].get<std::string>());
    if (operation.contains("value")) operation["value"] = expansion.value(operation["value"]);
    // The library asserts that what is added to can have members.
    if (!root.at(Pointer(operation["path"].get<std::string>()).parent_pointer()).is_structured())
      throw NothingToPick();
    root.patch_inplace(Json::array({std::move(operation)}));
  }
}

std::string Grammar::spelling(std::string_view rule, Random& random) const {
  Json nothing;
  Expansion expansion(file_.at("rules"), nothing, random);
  const Json value = expansion.value("$" + std::string(rule));
  return rule == "oddity" ? value.get<std::string>() : write(value);
}

}  // namespace desmo::fuzz
