#include "cli/types_option.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "io/settings/setting_text.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

/// Returns true if the detector can find the type.
bool is_findable(QuadricType type) {
  const auto words = words_of(type);
  return std::any_of(words.begin(), words.end(), [&](const auto& w) { return w.value == type; });
}

QuadricType type_named(const std::string& option, const std::string& name) {
  const auto type = quadric_type_from_string(name);
  if (type && is_findable(*type)) return *type;
  throw CLI::ValidationError(option, (type ? "type '" + name + "' is never found"
                                           : "unknown type '" + printable(name) + "'") +
                                         "; the types are " + io::list_words<QuadricType>());
}

}  // namespace

void add_types_option(CLI::App& app, const std::string& name, std::vector<QuadricType>& types,
                      const std::string& description) {
  const auto take = [name, &types](const std::string& list) {
    types.clear();
    std::istringstream in(list);
    for (std::string word; std::getline(in, word, ',');) types.push_back(type_named(name, word));
    if (types.empty()) throw CLI::ValidationError(name, "names no type");
  };
  app.add_option_function<std::string>(name, take, description)->type_name("TYPE,...");
}

}  // namespace quadrille
