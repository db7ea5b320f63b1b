#pragma once

#include <set>
#include <string_view>

#include "support/catch.hpp"

namespace quadrille::test {

/// Checks that each value of an enumeration, up to this last one, has a word of its own.
template <class Choice>
void check_words(Choice last) {
  std::set<std::string_view> words;
  for (int n = 0; n <= static_cast<int>(last); ++n) {
    const std::string_view word = to_string(static_cast<Choice>(n));
    CAPTURE(n, word);
    CHECK_FALSE(word.empty());
    CHECK(words.insert(word).second);
  }
}

}  // namespace quadrille::test
