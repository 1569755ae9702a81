#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace desmo::fuzz {

/// JSON to be spoilt: scalars and keys keep their spelling, so that a key given twice, NaN and
/// 1e999 can be written as well.
struct Tree {
  enum class Kind { scalar, list, object };

  Kind kind = Kind::scalar;
  std::string key;   ///< of a member, as spelt between the quotes
  std::string text;  ///< of a scalar, as spelt, quotes included
  std::vector<Tree> children;

  bool is_text() const { return kind == Kind::scalar && text.starts_with('"'); }
  bool is_number() const;
  double number() const;          ///< of a number
  std::string_view name() const;  ///< of a text, without quotes

  /// The member of that key. Null when there is none.
  Tree* find(std::string_view member);
  const Tree* find(std::string_view member) const;
  /// The member of that key, added when there is none.
  Tree& operator[](std::string_view member);
};

Tree scalar(std::string spelling);
Tree scalar(double number);
Tree string_tree(std::string_view name);
Tree list(std::vector<Tree> elements);
Tree object();

/// Puts a value in the place of another, under that one's key.
void put(Tree& place, Tree value);

/// Throws std::invalid_argument for what is not JSON; otherwise it is not particular.
Tree parse_tree(std::string_view text);

std::string write(const Tree& tree);

/// All nodes below and including this one, parents first. Valid until one of them is changed.
std::vector<Tree*> nodes(Tree& tree);

}  // namespace desmo::fuzz
