#include "cli/seed_option.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <limits>

#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

/// Returns what is wrong with the text of a seed; empty if it is valid.
std::string check_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, seed);
  if (error == std::errc{} && rest == end) return "";
  return "'" + printable(text) + "' is no whole number from 0 to " +
         std::to_string(std::numeric_limits<std::uint64_t>::max());
}

template <class Seed>
CLI::Option* add(CLI::App& app, Seed& seed, const std::string& what) {
  return app.add_option("--seed", seed, "Chooses " + what)
      ->type_name("N")
      ->check(CLI::Validator(check_seed, ""));
}

}  // namespace

CLI::Option* add_seed_option(CLI::App& app, std::uint64_t& seed, const std::string& what) {
  return add(app, seed, what);
}

CLI::Option* add_seed_option(CLI::App& app, std::optional<std::uint64_t>& seed,
                             const std::string& what) {
  return add(app, seed, what);
}

}  // namespace quadrille
