#include "tests/fuzz/tree.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace desmo::fuzz {
namespace {

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Tree document() {
    Tree tree = value();
    skip_space();
    if (at_ != text_.size()) fail();
    return tree;
  }

 private:
  [[noreturn]] void fail() const {
    throw std::invalid_argument("not JSON at " + std::to_string(at_));
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  bool take(char c) {
    skip_space();
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  std::string string() {
    const std::size_t begin = at_++;
    while (peek() != '"') {
      if (peek() == '\0') fail();
      at_ += peek() == '\\' ? 2 : 1;
    }
    return std::string(text_.substr(begin, ++at_ - begin));
  }

  Tree value() {
    skip_space();
    if (take('{')) return members();
    if (take('[')) return elements();
    if (peek() == '"') return scalar(string());
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n,]}", at_), text_.size());
    if (end == at_) fail();
    Tree tree = scalar(std::string(text_.substr(at_, end - at_)));
    at_ = end;
    return tree;
  }

  Tree members() {
    Tree tree = object();
    if (take('}')) return tree;
    do {
      skip_space();
      if (peek() != '"') fail();
      const std::string key = string();
      if (!take(':')) fail();
      tree.children.push_back(value());
      tree.children.back().key = key.substr(1, key.size() - 2);
    } while (take(','));
    if (!take('}')) fail();
    return tree;
  }

  Tree elements() {
    Tree tree = list({});
    if (take(']')) return tree;
    do tree.children.push_back(value());
    while (take(','));
    if (!take(']')) fail();
    return tree;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

void append(const Tree& tree, std::string& text) {
  if (tree.kind == Tree::Kind::scalar) {
    text += tree.text;
    return;
  }
  const bool is_object = tree.kind == Tree::Kind::object;
  text += is_object ? '{' : '[';
  for (std::size_t i = 0; i < tree.children.size(); ++i) {
    if (i > 0) text += ", ";
    if (is_object) text += '"' + tree.children[i].key + "\": ";
    append(tree.children[i], text);
  }
  text += is_object ? '}' : ']';
}

void collect(Tree& tree, std::vector<Tree*>& all) {
  all.push_back(&tree);
  for (Tree& child : tree.children) collect(child, all);
}

}  // namespace

bool Tree::is_number() const {
  return kind == Kind::scalar && !text.empty() &&
         (text[0] == '-' || (text[0] >= '0' && text[0] <= '9'));
}

double Tree::number() const { return std::strtod(text.c_str(), nullptr); }

std::string_view Tree::name() const { return std::string_view(text).substr(1, text.size() - 2); }

Tree* Tree::find(std::string_view member) {
  const auto at = std::ranges::find(children, member, &Tree::key);
  return kind == Kind::object && at != children.end() ? &*at : nullptr;
}

const Tree* Tree::find(std::string_view member) const {
  return const_cast<Tree*>(this)->find(member);
}

Tree& Tree::operator[](std::string_view member) {
  if (Tree* const found = find(member)) return *found;
  children.push_back(object());
  children.back().key = member;
  return children.back();
}

Tree scalar(std::string spelling) { return {Tree::Kind::scalar, {}, std::move(spelling), {}}; }

Tree scalar(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", number);
  return scalar(std::string(text));
}

Tree string_tree(std::string_view name) { return scalar('"' + std::string(name) + '"'); }

Tree list(std::vector<Tree> elements) { return {Tree::Kind::list, {}, {}, std::move(elements)}; }

Tree object() { return {Tree::Kind::object, {}, {}, {}}; }

void put(Tree& place, Tree value) {
  value.key = std::move(place.key);
  place = std::move(value);
}

Tree parse_tree(std::string_view text) { return Reader(text).document(); }

std::string write(const Tree& tree) {
  std::string text;
  append(tree, text);
  return text;
}

std::vector<Tree*> nodes(Tree& tree) {
  std::vector<Tree*> all;
  collect(tree, all);
  return all;
}

}  // namespace desmo::fuzz
