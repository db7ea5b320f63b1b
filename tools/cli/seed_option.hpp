#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace quadrille {

/// Adds --seed N, which accepts whole numbers from 0 on. CLI11 alone would wrap negative numbers
/// around.
/// @param seed  set to the number; must outlive the app
/// @param what  what the seed determines, such as "the scene"
CLI::Option* add_seed_option(CLI::App& app, std::uint64_t& seed, const std::string& what);
CLI::Option* add_seed_option(CLI::App& app, std::optional<std::uint64_t>& seed,
                             const std::string& what);

}  // namespace quadrille
