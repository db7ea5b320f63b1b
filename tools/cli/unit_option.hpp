#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds --unit m|mm, the unit of the coordinates of clouds. Options and settings are in metres.
/// @param unit  set to the length of that unit [m]; must outlive the app
void add_unit_option(CLI::App& app, double& unit);

}  // namespace quadrille
