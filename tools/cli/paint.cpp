#include "cli/paint.hpp"

#include <fmt/color.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace quadrille {
namespace {

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

std::string styled(bool is_on, const fmt::text_style& style, const std::string& text) {
  return is_on ? fmt::format(style, "{}", text) : text;
}

}  // namespace

Paint Paint::of_stdout() {
  const std::string_view terminal = variable("TERM");
  const bool has_colours = isatty(STDOUT_FILENO) != 0 && !terminal.empty() && terminal != "dumb";
  return Paint(has_colours && variable("NO_COLOR").empty());
}

std::string Paint::head(const std::string& text) const {
  return styled(is_on_, fmt::emphasis::bold, text);
}

std::string Paint::faint(const std::string& text) const {
  return styled(is_on_, fmt::emphasis::faint, text);
}

std::string Paint::good(const std::string& text) const {
  return styled(is_on_, fmt::fg(fmt::terminal_color::green), text);
}

std::string Paint::bad(const std::string& text) const {
  return styled(is_on_, fmt::fg(fmt::terminal_color::red), text);
}

}  // namespace quadrille
