#pragma once

#include <limits>
#include <type_traits>
#include <vector>

#include "quadrille/detector/export.hpp"
#include "quadrille/detector/word.hpp"

namespace quadrille {

/// Describes one option, except for its default, which stands at its field. Range checks,
/// configuration files, error messages and `quadrille config` come from this table.
struct Setting {
  /// Describes a number or a list of numbers.
  constexpr Setting(const char* its_name, const char* its_unit, double smallest, double largest,
                    const char* reason)
      : name(its_name), unit(its_unit), min(smallest), max(largest), why(reason) {}
  /// Describes an option for which any value of its type is valid.
  constexpr Setting(const char* its_name, const char* reason) : name(its_name), why(reason) {}

  /// Key in configuration files, including its tables, such as "planes.sigmas".
  const char* name;
  /// Unit; empty for plain numbers.
  const char* unit = "";
  /// Smallest and largest value; for a list, of each element.
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  /// Meaning of the option, and the reason for its value.
  const char* why;
};

/// Checks a value against its row.
/// @throws std::invalid_argument "NAME = VALUE: must lie between MIN and MAX" if it is out of range
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
