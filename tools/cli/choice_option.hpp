#pragma once

#include <CLI/App.hpp>
#include <CLI/Error.hpp>
#include <string>
#include <utility>
#include <vector>

namespace quadrille {

/// The words that an option takes, with what each means.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// "first|second|third".
template <class Value>
std::string join_names(const Choices<Value>& choices, const std::string& separator) {
  std::string text;
  for (const auto& [name, value] : choices) text += (text.empty() ? "" : separator) + name;
  return text;
}

/// Adds an option that takes one of a few words, and nothing else.
/// @param value  gets what the word means; must outlive the app
template <class Value, class Target>
CLI::Option* add_choice_option(CLI::App& app, const std::string& name, Target& value,
                               const Choices<Value>& choices, const std::string& description) {
  const auto choose = [name, choices, &value](const std::string& word) {
    for (const auto& [choice, meaning] : choices) {
      if (word != choice) continue;
      value = meaning;
      return;
    }
    throw CLI::ValidationError(name, "'" + word + "' is none of: " + join_names(choices, ", "));
  };
  return app.add_option_function<std::string>(name, choose, description)
      ->type_name(join_names(choices, "|"));
}

}  // namespace quadrille
