#pragma once

#include <stdexcept>
#include <string>

#include "quadrille/detector/options.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::python {

/// Returns what a word stands for among pairs of words and meanings.
/// @throws std::invalid_argument listing the words
template <class Words>
auto meaning_of(const std::string& word, const Words& words, const std::string& what) {
  std::string known;
  for (const auto& [name, meaning] : words) {
    if (name == word) return meaning;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  throw std::invalid_argument("no " + what + " '" + printable(word) + "'; there are: " + known);
}

inline QuadricType type_of(const std::string& name) {
  return meaning_of(name, words_of(QuadricType{}), "type");
}

}  // namespace quadrille::python
