#include <algorithm>
#include <array>
#include <utility>

#include "tests/fuzz/mutations.h"

namespace desmo::fuzz {
namespace {

/// A node for which a condition holds. Null when it holds for none.
template <class Condition>
Tree* any(Tree& root, Random& random, Condition condition) {
  std::vector<Tree*> all = nodes(root);
  std::erase_if(all, [&](const Tree* n) { return !condition(*n); });
  return all.empty() ? nullptr : random.pick(all);
}

Tree* any_container(Tree& root, Random& random) {
  return any(root, random, [](const Tree& n) { return !n.children.empty(); });
}

std::vector<std::string> all_names(Tree& root) {
  std::vector<std::string> names;
  for (const Tree* n : nodes(root)) {
    if (n->is_text()) names.emplace_back(n->name());
    if (!n->key.empty()) names.push_back(n->key);
  }
  return names;
}

void remove_child(Tree& root, Random& random) {
  if (Tree* const at = any_container(root, random))
    at->children.erase(at->children.begin() +
                       static_cast<std::ptrdiff_t>(random.below(at->children.size())));
}

void duplicate_child(Tree& root, Random& random) {
  Tree* const at = any_container(root, random);
  if (!at) return;
  Tree copy = random.pick(at->children);
  // Under the same key it is an error; under a new one, another entity in the same place.
  if (!random.one_in(4)) copy.key += "_2";
  at->children.insert(
      at->children.begin() + static_cast<std::ptrdiff_t>(random.below(at->children.size() + 1)),
      std::move(copy));
}

void permute_children(Tree& root, Random& random) {
  Tree* const at = any_container(root, random);
  if (!at) return;
  for (std::size_t i = at->children.size(); i > 1; --i)
    std::swap(at->children[i - 1], at->children[random.below(i)]);
}

void rename_key(Tree& root, Random& random) {
  Tree* const at = any(root, random, [](const Tree& n) { return !n.key.empty(); });
  if (!at) return;
  const std::vector<std::string> names = all_names(root);
  if (names.empty()) return;
  at->key = random.one_in(3) ? at->key + (random.one_in(2) ? "\\u0007" : "x") : random.pick(names);
}

void swap_values(Tree& root, Random& random) {
  const std::vector<Tree*> all = nodes(root);
  Tree &a = *random.pick(all), &b = *random.pick(all);
  // Within each other they cannot change places.
  for (const auto& [outer, inner] : {std::pair{&a, &b}, std::pair{&b, &a}})
    for (const Tree* n : nodes(*outer))
      if (n == inner) return;
  Tree first = a, second = b;
  put(a, std::move(second));
  put(b, std::move(first));
}

void copy_value(Tree& root, Random& random) {
  const std::vector<Tree*> all = nodes(root);
  Tree copy = *random.pick(all);
  if (nodes(copy).size() < 200) put(*random.pick(all), std::move(copy));
}

void replace_name(Tree& root, Random& random) {
  Tree* const at = any(root, random, [](const Tree& n) { return n.is_text(); });
  if (!at) return;
  static constexpr std::array<std::string_view, 16> odd = {
      "*",   "**", "?",  "",        "ground",     "-",       "x",        "*a*",
      "a/*", ".",  "..", "\\u0000", "\\u001b[0m", "\\u202e", "\xc3\xa4", "1"};
  const std::vector<std::string> names = all_names(root);
  if (names.empty()) return;
  const std::string old(at->name());
  switch (random.below(6)) {
    case 0:
      put(*at, string_tree(random.pick(odd)));
      break;
    case 1:
      put(*at, string_tree("-" + old));
      break;
    case 2:
      put(*at, string_tree(old + "*"));
      break;
    default:
      put(*at, string_tree(random.pick(names)));
      break;
  }
}

// An entity keeps its references under its new name.
void rename_everywhere(Tree& root, Random& random) {
  const std::vector<std::string> names = all_names(root);
  if (names.empty()) return;
  const std::string old = random.pick(names);
  const std::string renamed = random.one_in(3)   ? std::string(100 + random.below(2), 'n')
                              : random.one_in(2) ? random.pick(names)
                                                 : "n" + old;
  for (Tree* n : nodes(root)) {
    if (n->key == old) n->key = renamed;
    if (n->is_text() && n->name() == old) n->text = '"' + renamed + '"';
  }
}

void spoil_number(Tree& root, Random& random) {
  Tree* const at = any(root, random, [](const Tree& n) { return n.is_number(); });
  if (at) put(*at, scalar(std::string(extreme_number(random))));
}

void change_number(Tree& root, Random& random) {
  Tree* const at = any(root, random, [](const Tree& n) { return n.is_number(); });
  if (!at) return;
  const double old = at->number();
  switch (random.below(5)) {
    case 0:
      put(*at, scalar(-old));
      break;
    case 1:
      put(*at, scalar(old * (1 + 1e-9 * random.around_zero())));
      break;
    case 2:
      put(*at, scalar(old + random.around_zero()));
      break;
    default:
      put(*at, scalar(old * (1 + 0.3 * random.around_zero())));
      break;
  }
}

void change_kind(Tree& root, Random& random) {
  static constexpr std::array<std::string_view, 10> others = {
      "null", "true", "false", "[]", "{}", "\"\"", "0", "[[]]", "{\"a\": {}}", "[0, 0, 0]"};
  const std::vector<Tree*> all = nodes(root);
  put(*random.pick(all), scalar(std::string(random.pick(others))));
}

void wrap(Tree& root, Random& random) {
  const std::vector<Tree*> all = nodes(root);
  Tree& at = *random.pick(all);
  Tree inner = at;
  for (std::size_t depth = 1 + random.below(random.one_in(4) ? 40 : 2); depth > 0; --depth) {
    Tree outer = list({});
    outer.children.push_back(std::move(inner));
    inner = std::move(outer);
  }
  put(at, std::move(inner));
}

constexpr TreeMutation all_json_mutations[] = {
    remove_child, duplicate_child, permute_children, rename_key,        swap_values,
    copy_value,   replace_name,    replace_name,     rename_everywhere, spoil_number,
    spoil_number, change_number,   change_number,    change_kind,       wrap};

}  // namespace

std::span<const TreeMutation> json_mutations() { return all_json_mutations; }

Tree* mechanism_in(Tree& root) {
  Tree* const inner = root.find("mechanism");
  if (inner) return inner->kind == Tree::Kind::object ? inner : nullptr;
  return root.kind == Tree::Kind::object ? &root : nullptr;
}

std::vector<std::string> names_under(const Tree& mechanism, std::string_view member) {
  std::vector<std::string> names;
  if (const Tree* const found = mechanism.find(member); found && found->kind == Tree::Kind::object)
    for (const Tree& child : found->children) names.push_back(child.key);
  return names;
}

}  // namespace desmo::fuzz
