#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace quadrille {

/// The words that an option accepts, and the meaning of each.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// Adds an option that accepts only certain words.
/// @param choose  called with the index of the given word
CLI::Option* add_word_option(CLI::App& app, const std::string& name,
                             const std::vector<std::string>& words,
                             const std::function<void(std::size_t)>& choose,
                             const std::string& description);

/// Adds an option that accepts only certain words.
/// @param value  set to the meaning of the given word; must outlive the app
template <class Value, class Target>
CLI::Option* add_choice_option(CLI::App& app, const std::string& name, Target& value,
                               const Choices<Value>& choices, const std::string& description) {
  std::vector<std::string> words;
  for (const auto& [word, meaning] : choices) words.push_back(word);
  const auto choose = [choices, &value](std::size_t place) { value = choices[place].second; };
  return add_word_option(app, name, words, choose, description);
}

}  // namespace quadrille
