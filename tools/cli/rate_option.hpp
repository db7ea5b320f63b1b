#pragma once

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace quadrille {

/// Adds --rate HZ, the clouds per second, within these limits.
/// @param rate  set to the rate; must outlive the app
CLI::Option* add_rate_option(CLI::App& app, double& rate, double least, double most);

}  // namespace quadrille
