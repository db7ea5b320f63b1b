#pragma once

#include <string_view>

namespace quadrille {

/// The word that stands for a value of an enumeration in files, messages and options. A function
/// words_of() beside an enumeration lists the words of its values.
template <class Choice>
struct Word {
  std::string_view word;
  Choice value;
};

/// The word for a value of such an enumeration.
template <class Choice>
requires requires(Choice choice) { words_of(choice); }
constexpr std::string_view to_string(Choice choice) {
  for (const auto& [word, value] : words_of(choice)) {
    if (value == choice) return word;
  }
  return {};
}

}  // namespace quadrille
