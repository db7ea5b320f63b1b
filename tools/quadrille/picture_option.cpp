#include "quadrille/picture_option.hpp"

#include <CLI/CLI.hpp>

namespace quadrille {
namespace {

/// Empty if a path names a PNG file, else what is wrong.
std::string check_picture_path(const std::string& path) {
  return path.ends_with(".png") ? "" : "'" + path + "' must end in .png: pictures are PNG files";
}

}  // namespace

void add_picture_option(CLI::App& command, std::string& path, const std::string& what) {
  command.add_option("--picture", path, "Draw " + what)
      ->type_name("FILE.png")
      ->check(CLI::Validator(check_picture_path, ""));
}

}  // namespace quadrille
