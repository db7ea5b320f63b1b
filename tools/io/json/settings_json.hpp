#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/json/json.hpp"
#include "io/settings/setting_text.hpp"

namespace quadrille::io {

/// Returns the value of an option as JSON: a number, true or false, a word, or a list of these.
template <class Field>
Json json_of(const Field& field) {
  if constexpr (Choice<Field>) {
    return std::string(to_string(field));
  } else if constexpr (List<Field>) {
    Json array = Json::array();
    for (const auto& element : field) array.push_back(json_of(element));
    return array;
  } else {
    return field;
  }
}

/// Adds the options that differ from their defaults, by their keys in configuration files.
template <class Options>
void add_changed(const Options& options, Json* settings) {
  std::vector<std::string> defaults;
  const Options unchanged;
  Options::visit(unchanged,
                 [&](const auto& field, const Setting&) { defaults.push_back(toml_of(field)); });
  std::size_t row = 0;
  Options::visit(options, [&](const auto& field, const Setting& setting) {
    if (toml_of(field) != defaults[row++]) (*settings)[setting.name] = json_of(field);
  });
}

/// Returns the settings that differ from their defaults: {"search.basis": "pairs"}.
template <class... Options>
Json changed_settings(const Options&... options) {
  Json settings = Json::object();
  (add_changed(options, &settings), ...);
  return settings;
}

}  // namespace quadrille::io
