#pragma once

#include <string>

#include "quadrille/grasping/surroundings.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// Adds --octomap and --support, which fill the map and the support; `known` must outlive the app.
/// @param frame  the frame in which they are, for the descriptions
void add_surroundings_options(CLI::App& app, Surroundings& known, const std::string& frame);

}  // namespace quadrille
