#include "quadrille/picture_option.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

constexpr std::array<std::pair<const char*, ViewSide>, 3> kSides = {
    {{"camera", ViewSide::kCamera}, {"top", ViewSide::kTop}, {"side", ViewSide::kSide}}};

/// Returns what is wrong with the path of a picture; empty if it is valid.
std::string check_picture_path(const std::string& path) {
  return is_picture_path(path) ? "" : "'" + path + "' must end in .png, .svg or .pdf";
}

/// Parses a list of view names; if one is wrong, returns none and says so in `error`.
std::vector<ViewSide> parse_sides(const std::string& list, std::string* error) {
  std::vector<ViewSide> sides;
  for (const std::string& word : CLI::detail::split(list, ',')) {
    const auto* side = std::find_if(kSides.begin(), kSides.end(),
                                    [&](const auto& known) { return word == known.first; });
    if (side == kSides.end()) {
      *error =
          fmt::format("'{}' is none of: camera, top, side; a list is camera,top", printable(word));
      return {};
    }
    if (std::find(sides.begin(), sides.end(), side->second) == sides.end()) {
      sides.push_back(side->second);
    }
  }
  return sides;
}

const char* name_of(ViewSide side) {
  return std::find_if(kSides.begin(), kSides.end(),
                      [&](const auto& known) { return known.second == side; })
      ->first;
}

}  // namespace

void PictureArguments::add_to(CLI::App& command, const std::string& what) {
  CLI::Option* picture =
      command
          .add_option("--picture", path,
                      "Draw " + what + "; of several inputs, _INPUT is put before the ending")
          ->type_name("FILE.png|svg|pdf")
          ->check(CLI::Validator(check_picture_path, ""));
  command
      .add_option_function<std::string>(
          "--picture-view",
          [this](const std::string& list) {
            std::string error;
            sides = parse_sides(list, &error);
            if (!error.empty()) throw CLI::ValidationError("--picture-view", error);
          },
          "Where pictures are drawn from; of several views, _VIEW is put before the ending "
          "[camera]")
      ->type_name("camera|top|side,…")
      ->needs(picture);
}

void PictureArguments::write(const std::string& file, const PictureContent& content) const {
  const auto draw = [&](const std::string& name, ViewSide side) {
    write_picture(name, content, {.side = side});
    // With several inputs or views, each picture has a name of its own, which is printed.
    if (name != path) fmt::print(stderr, "quadrille: drew {}\n", name);
  };
  if (sides.size() < 2) return draw(file, sides.empty() ? ViewSide::kCamera : sides.front());
  const std::filesystem::path whole(file);
  for (const ViewSide side : sides) {
    const std::string name =
        fmt::format("{}_{}{}", whole.stem().string(), name_of(side), whole.extension().string());
    draw((whole.parent_path() / name).string(), side);
  }
}

}  // namespace quadrille
