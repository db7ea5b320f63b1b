#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "io/settings/setting_text.hpp"
#include "io/settings/toml_file.hpp"

namespace quadrille::io {

/// Sets a field from a node; returns false if the node's type or range does not fit.
template <class Field>
bool assign(const toml::node& node, Field* field) {
  if constexpr (Choice<Field>) {
    for (const auto& [word, value] : words_of(*field)) {
      if (node.value_or(std::string_view{}) != word) continue;
      *field = value;
      return true;
    }
    return false;
  } else if constexpr (List<Field>) {
    const toml::array* array = node.as_array();
    if (array == nullptr) return false;
    Field read;
    for (const toml::node& element : *array) {
      if (!assign(element, &read.emplace_back())) return false;
    }
    *field = std::move(read);
    return true;
  } else if constexpr (std::is_same_v<Field, bool>) {
    const auto value = node.value_exact<bool>();
    if (value) *field = *value;
    return value.has_value();
  } else if constexpr (std::is_floating_point_v<Field>) {
    if (!node.is_number()) return false;
    *field = *node.value<double>();
    return true;
  } else {
    const auto value = node.value_exact<std::int64_t>();
    if (!value || !std::in_range<Field>(*value)) return false;
    *field = static_cast<Field>(*value);
    return true;
  }
}

/// Describes the values that a field can have, for errors.
template <class Field>
std::string expected() {
  if constexpr (Choice<Field>) {
    return "one of " + list_words<Field>();
  } else if constexpr (List<Field>) {
    return "a list, each element " + expected<typename ElementOf<Field>::type>();
  } else if constexpr (std::is_same_v<Field, bool>) {
    return "true or false";
  } else if constexpr (std::is_floating_point_v<Field>) {
    return "a number";
  } else {
    return std::is_unsigned_v<Field> ? "a non-negative integer" : "an integer";
  }
}

/// Reads the options of one struct after the other from a file, and remembers which keys are known.
class SettingReader {
 public:
  /// @throws FileError if the file is missing or not TOML
  explicit SettingReader(const std::string& path) : path_(path), table_(read_toml(path)) {}

  /// Parses TOML whose name in errors is `path`.
  /// @throws FileError if the text is not TOML
  SettingReader(std::string_view text, const std::string& path)
      : path_(path), table_(parse_toml(text, path)) {}

  /// Sets the options that the file gives, and leaves the others unchanged.
  /// @throws FileError naming line and key if a value has the wrong type
  template <class Options>
  void read(Options* options) {
    Options::visit(*options, [&](auto& field, const Setting& setting) {
      using Field = std::remove_reference_t<decltype(field)>;
      const toml::node* node = find(setting.name);
      if (node != nullptr && !assign(*node, &field)) refuse(*node, setting.name, expected<Field>());
    });
  }

  /// Checks that every key was requested by a read(), and then the ranges.
  /// @param foreign  a table that belongs to other programs; empty for none
  /// @throws FileError naming line and key, or the field that is out of range
  template <class... Options>
  void check(std::string_view foreign, const Options&... options) const {
    refuse_unknown(table_, "", foreign);
    try {
      (options.check(), ...);
    } catch (const std::invalid_argument& error) {
      throw FileError(path_, "", error.what());
    }
  }

  /// The keys that the file gives, in their current spelling.
  const std::set<std::string>& given() const { return given_; }

 private:
  /// Returns the node of a key, or of its old spelling; null if there is none.
  const toml::node* find(const std::string& name);
  [[noreturn]] void refuse(const toml::node& node, const std::string& name,
                           const std::string& wanted) const;
  void refuse_unknown(const toml::table& table, const std::string& prefix,
                      std::string_view foreign) const;

  std::string path_;
  toml::table table_;
  std::set<std::string> known_, given_, old_;
};

}  // namespace quadrille::io
