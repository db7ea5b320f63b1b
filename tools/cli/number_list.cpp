#include "cli/number_list.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <optional>

#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

/// Returns the numbers of a comma-separated list; nullopt if one is not a finite number.
std::optional<std::vector<double>> numbers_of(const std::string& list) {
  std::vector<double> numbers;
  const char* at = list.data();
  const char* const end = at + list.size();
  while (true) {
    double number = 0.0;
    const auto [rest, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
    if (rest == end) return numbers;
    if (*rest != ',') return std::nullopt;
    at = rest + 1;
  }
}

}  // namespace

std::vector<double> numbers_of(const std::string& option, const std::string& list,
                               std::size_t count, const std::string& form) {
  const auto numbers = numbers_of(list);
  if (!numbers || numbers->size() != count) {
    throw CLI::ValidationError(option,
                               fmt::format("'{}' is not {}: {} finite numbers with commas between",
                                           printable(list), form, count));
  }
  return *numbers;
}

}  // namespace quadrille
