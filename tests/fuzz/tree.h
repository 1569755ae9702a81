#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace desmo::fuzz {

/// A JSON document to be mutated. Scalars and keys keep their spelling, so that it can also hold
/// duplicate keys, NaN and 1e999.
struct Tree {
  enum class Kind { scalar, list, object };

  Kind kind = Kind::scalar;
  std::string key;   ///< key of a member, as spelt between the quotes
  std::string text;  ///< text of a scalar, as spelt, quotes included
  std::vector<Tree> children;

  bool is_text() const { return kind == Kind::scalar && text.starts_with('"'); }
  bool is_number() const;
  double number() const;          ///< value of a number
  std::string_view name() const;  ///< content of a text, without quotes

  /// Return the member of that key, or null.
  Tree* find(std::string_view member);
  const Tree* find(std::string_view member) const;
  /// Returns the member of that key; adds it when there is none.
  Tree& operator[](std::string_view member);
};

Tree scalar(std::string spelling);
Tree scalar(double number);
Tree string_tree(std::string_view name);
Tree list(std::vector<Tree> elements);
Tree object();

/// Replaces a value; the key stays.
void put(Tree& place, Tree value);

/// Parses JSON, with leniency about scalars. Throws std::invalid_argument for other texts.
Tree parse_tree(std::string_view text);

std::string write(const Tree& tree);

/// Returns this node and all nodes below it, parents first. The pointers are valid until a node
/// changes.
std::vector<Tree*> nodes(Tree& tree);

}  // namespace desmo::fuzz
