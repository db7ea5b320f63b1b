#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "quadrille/detector/setting.hpp"

namespace quadrille::io {

/// An enumeration whose values have words in files.
template <class Field>
concept Choice = requires(Field field) {
  words_of(field);
};

/// Returns the words of an enumeration, separated by commas.
template <Choice Field>
std::string list_words() {
  std::string list;
  for (const auto& [word, value] : words_of(Field{})) {
    list += (list.empty() ? "" : ", ") + std::string(word);
  }
  return list;
}

template <class Field>
struct ElementOf {};
template <class Element>
struct ElementOf<std::vector<Element>> {
  using type = Element;
};

/// A list of numbers or words.
template <class Field>
concept List = requires {
  typename ElementOf<Field>::type;
};

/// Formats a real number as TOML. Whole numbers keep a digit after the point, which some readers
/// require.
inline std::string toml_of(double value) {
  const std::string text = fmt::format("{}", value);
  const bool whole = std::isfinite(value) && text.find_first_of(".e") == std::string::npos;
  return whole ? text + ".0" : text;
}

/// Formats the value of an option as TOML; equal texts are equal values.
template <class Field>
std::string toml_of(const Field& field) {
  if constexpr (Choice<Field>) {
    return fmt::format("\"{}\"", to_string(field));
  } else if constexpr (List<Field>) {
    std::string text;
    for (const auto& element : field) text += (text.empty() ? "" : ", ") + toml_of(element);
    return "[" + text + "]";
  } else {
    return fmt::format("{}", field);
  }
}

}  // namespace quadrille::io
