#pragma once

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>

namespace quadrille {

/// Empty if a text is a seed, else what is wrong with it.
inline std::string check_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, seed);
  if (error == std::errc{} && rest == end) return "";
  return "'" + text + "' is no whole number from 0 to " +
         std::to_string(std::numeric_limits<std::uint64_t>::max());
}

/// Adds --seed N, which takes whole numbers from 0 on. CLI11 alone would wrap negative ones around.
/// @param seed  gets the number; must outlive the app
/// @param what  what the seed chooses, such as "the scene"
template <class Seed>
CLI::Option* add_seed_option(CLI::App& app, Seed& seed, const std::string& what) {
  return app.add_option("--seed", seed, "Chooses " + what)
      ->type_name("N")
      ->check(CLI::Validator(check_seed, ""));
}

}  // namespace quadrille
