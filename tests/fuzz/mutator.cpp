#include "tests/fuzz/mutator.h"

#include <cstdlib>

#include "tests/fuzz/mutations.h"

namespace desmo::fuzz {
namespace {

constexpr int max_units = 3;
constexpr std::size_t max_text = 400'000;

/// A mutation that needs what the input has not ends where it sees that.
template <class Mutation, class Input>
void apply(const Mutation& mutation, Input& input, Random& random) {
  try {
    mutation(input, random);
  } catch (const NothingToPick&) {
  }
}

// Small changes far more often than large ones, so that many results are solved.
void mutate(Tree& tree, Random& random) {
  const std::span<const TreeMutation> table = random.one_in(8)   ? json_mutations()
                                              : random.one_in(3) ? geometry_mutations()
                                              : random.one_in(4) ? scene_mutations()
                                                                 : mechanism_mutations();
  const TreeMutation change = random.pick(table);
  apply(change, tree, random);
}

std::size_t few(Random& random) {
  std::size_t count = 1;
  while (count < 8 && random.one_in(3)) ++count;
  return count;
}

}  // namespace

Mutator::Mutator(const std::vector<Sample>& corpus) {
  for (const Sample& sample : corpus) trees_.push_back(parse_tree(sample.text));
}

// A member of one file takes the place of the member of that key in another.
Tree Mutator::spliced(Tree tree, Random& random) const {
  Tree donor = random.pick(trees_);
  std::vector<Tree*> places = nodes(tree), gifts = nodes(donor);
  for (int attempt = 0; attempt < 50; ++attempt) {
    Tree& place = *random.pick(places);
    const Tree& gift = *random.pick(gifts);
    if (place.key.empty() || place.key != gift.key) continue;
    put(place, gift);
    break;
  }
  return tree;
}

std::string Mutator::make(Random& random) const {
  Tree tree = random.pick(trees_);
  const std::size_t way = random.below(10);
  if (way == 0) tree = spliced(std::move(tree), random);
  if (way < 9)
    for (std::size_t count = few(random); count > 0; --count) mutate(tree, random);
  if (!random.one_in(4)) give_motion_to_drivers(tree);
  std::string text = write(tree);
  const std::span<const TextMutation> of_text = text_mutations();
  if (way >= 8)
    for (std::size_t count = few(random); count > 0; --count)
      apply(random.pick(of_text), text, random);
  if (text.size() > max_text) text.resize(max_text);
  return with_few_units(std::move(text), max_units);
}

std::string with_few_units(std::string text, int most) {
  for (const std::string_view key : {"\"axles\"", "\"dyads\""})
    for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at)) {
      at += key.size();
      const std::size_t begin = text.find_first_not_of(" \t\r\n:", at);
      if (begin == text.npos) break;
      const std::size_t end = text.find_first_not_of("+-.0123456789eE", begin);
      const std::size_t length = (end == text.npos ? text.size() : end) - begin;
      if (std::strtod(text.substr(begin, length).c_str(), nullptr) > most)
        text.replace(begin, length, std::to_string(most));
    }
  return text;
}

}  // namespace desmo::fuzz
