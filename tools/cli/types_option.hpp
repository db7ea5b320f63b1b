#pragma once

#include <string>
#include <vector>

#include "quadrille/detector/quadric.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// Adds an option that accepts detectable types, separated by commas.
/// @param types  set to the types; must outlive the app
void add_types_option(CLI::App& app, const std::string& name, std::vector<QuadricType>& types,
                      const std::string& description);

}  // namespace quadrille
