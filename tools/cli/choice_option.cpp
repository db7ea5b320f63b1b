#include "cli/choice_option.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

}  // namespace

CLI::Option* add_word_option(CLI::App& app, const std::string& name,
                             const std::vector<std::string>& words,
                             const std::function<void(std::size_t)>& choose,
                             const std::string& description) {
  const auto take = [name, words, choose](const std::string& word) {
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end()) {
      throw CLI::ValidationError(name,
                                 "'" + printable(word) + "' is none of: " + join(words, ", "));
    }
    choose(static_cast<std::size_t>(found - words.begin()));
  };
  return app.add_option_function<std::string>(name, take, description)->type_name(join(words, "|"));
}

}  // namespace quadrille
