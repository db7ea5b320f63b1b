#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace quadrille {

/// Adds --seed N, which takes whole numbers from 0 on. CLI11 alone would wrap negative ones around.
/// @param seed  gets the number; must outlive the app
/// @param what  what the seed chooses, such as "the scene"
CLI::Option* add_seed_option(CLI::App& app, std::uint64_t& seed, const std::string& what);
CLI::Option* add_seed_option(CLI::App& app, std::optional<std::uint64_t>& seed,
                             const std::string& what);

}  // namespace quadrille
