#pragma once

#include <limits>
#include <string_view>
#include <type_traits>
#include <vector>

#include "quadrille/detector/export.hpp"

namespace quadrille {

/// A row of the table of options: all that there is to say of one, but for its default, which
/// stands at its field. Checks, configuration files, errors and `quadrille config` come from it.
struct Setting {
  /// For numbers, and for lists of them.
  constexpr Setting(const char* its_name, const char* its_unit, double smallest, double largest,
                    const char* reason)
      : name(its_name), unit(its_unit), min(smallest), max(largest), why(reason) {}
  /// For what any value of its type suits.
  constexpr Setting(const char* its_name, const char* reason) : name(its_name), why(reason) {}

  /// The key in configuration files with its tables, such as "planes.sigmas".
  const char* name;
  /// Empty for plain numbers.
  const char* unit = "";
  /// Smallest and largest value; of a list, those of each element.
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  /// What it does, and why it is as it is.
  const char* why;
};

/// The word that stands for a value of an enumeration in files. An enumeration among the options
/// has a function words_of() with the words for all of its values that may be chosen.
template <class Choice>
struct Word {
  std::string_view word;
  Choice value;
};

/// The word for a value; empty if it has none.
template <class Choice>
constexpr std::string_view word_of(Choice choice) {
  for (const auto& [word, value] : words_of(choice)) {
    if (value == choice) return word;
  }
  return {};
}

/// @throws std::invalid_argument "NAME = VALUE: must lie between MIN and MAX" if it does not
QUADRILLE_EXPORT void check_range(const Setting& setting, double value);
QUADRILLE_EXPORT void check_range(const Setting& setting, int value);

/// Checks each option of a struct against its row.
/// @throws std::invalid_argument naming the first option that is out of range
template <class Options>
void check_ranges(const Options& options) {
  Options::visit(options, [](const auto& field, const Setting& setting) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (std::is_same_v<Field, double> || std::is_same_v<Field, int>) {
      check_range(setting, field);
    } else if constexpr (std::is_same_v<Field, std::vector<double>>) {
      for (const double element : field) check_range(setting, element);
    }
  });
}

}  // namespace quadrille
