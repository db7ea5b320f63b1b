#include "cli/rate_option.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <string>

#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

/// Returns what is wrong with the text of a rate; empty if it is one within the limits.
std::string check_rate(const std::string& text, double least, double most) {
  double rate = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, rate);
  const bool fits = error == std::errc{} && rest == end && rate >= least && rate <= most;
  return fits ? "" : fmt::format("'{}' is no number from {} to {}", printable(text), least, most);
}

}  // namespace

CLI::Option* add_rate_option(CLI::App& app, double& rate, double least, double most) {
  return app.add_option("--rate", rate, "Clouds per second")
      ->check(CLI::Validator(
          [least, most](const std::string& text) { return check_rate(text, least, most); }, ""))
      ->type_name("HZ");
}

}  // namespace quadrille
