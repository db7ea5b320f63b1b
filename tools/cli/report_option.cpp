#include "cli/report_option.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

std::string check_page_path(const std::string& path) {
  const std::string suffix = CLI::detail::to_lower(std::filesystem::path(path).extension());
  const bool ends_well = suffix == ".html" || suffix == ".htm";
  return ends_well ? "" : fmt::format("'{}' must end in .html", printable(path));
}

}  // namespace

void add_report_option(CLI::App& command, std::string& path, const std::string& what) {
  command
      .add_option("--report-html", path,
                  fmt::format("Write a page with {}, for any browser, without a network", what))
      ->type_name("FILE.html")
      ->check(CLI::Validator(check_page_path, ""));
}

}  // namespace quadrille
