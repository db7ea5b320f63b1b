#include "io/describe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::io {
namespace {

double shown_value(const Dimension& dimension) {
  return dimension.value * (is_angle(dimension.name) ? 180.0 / std::numbers::pi : 1000.0);
}

const char* unit_of(const Dimension& dimension) { return is_angle(dimension.name) ? "deg" : "mm"; }

std::string short_name(const std::string& name) {
  if (name == "radius") return "r";
  if (name == "length") return "l";
  if (name == "height") return "h";
  if (name.starts_with("half_angle")) return fmt::format("angle{}", name.substr(10));
  if (name.starts_with("focal_")) return fmt::format("f{}", name.substr(6));
  return name;
}

}  // namespace

std::string count_of(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string list_channels(const std::map<std::string, std::int64_t>& counts) {
  constexpr std::size_t kShown = 12, kMaxBytes = 200;
  std::string text;
  std::size_t shown = 0;
  for (const auto& [channel, count] : counts) {
    if (shown == kShown || text.size() > kMaxBytes)
      return fmt::format("{} and {} more", text, counts.size() - shown);
    text += fmt::format("{}{} ({})", shown++ == 0 ? "" : ", ", printable(channel), count);
  }
  return text;
}

std::string describe(const Dimension& dimension) {
  return fmt::format("{:.1f} {}{}", shown_value(dimension), unit_of(dimension),
                     std::isfinite(dimension.std) ? "" : "*");
}

std::string describe_dimensions(const Detection& detection) {
  std::string text;
  for (const Dimension& dimension : detection.dimensions) {
    text += (text.empty() ? "" : ", ") + dimension.name + " " + describe(dimension);
  }
  if (shows_inside(detection)) text += ", its inside";
  return text;
}

std::string describe_box(const Box& box) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    text += fmt::format("{}{:.1f}", i == 0 ? "" : " x ", 1000.0 * box.size[i]);
    if (box.seen[i]) continue;
    text += fmt::format(" ({:.1f} to {:.1f})", 1000.0 * box.inner_B.sizes()[i],
                        1000.0 * box.outer_B.sizes()[i]);
  }
  if (box.faces.empty()) return text + " mm, no detected face";
  text += box.faces.size() == 1 ? " mm, face" : " mm, faces";
  for (const int id : box.faces) text += fmt::format(" {}", id);
  return text;
}

std::string describe_body(const SceneBody& body) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    const double size = 1000.0 * body.size[i];
    text += i == 0 ? "" : " x ";
    text += body.seen[static_cast<std::size_t>(i)] ? fmt::format("{:.1f}", size)
                                                   : fmt::format("({:.1f})", size);
  }
  text += " mm";
  if (body.standing_on) text += fmt::format(", on {}", *body.standing_on);
  if (!body.parts.empty()) text += fmt::format(", parts {}", fmt::join(body.parts, " "));
  if (body.wall) text += ", " + describe_wall(*body.wall);
  return text;
}

std::string describe_lump(const SceneBody& lump) {
  const Eigen::Vector3d size = 1000.0 * lump.size;
  return fmt::format("seen {:.0f} x {:.0f} x {:.0f} mm", size.x(), size.y(), size.z());
}

std::string describe_wall(const BodyWall& wall) {
  return fmt::format("wall {:.1f} ± {:.1f} mm", 1000.0 * wall.thickness, 1000.0 * wall.std);
}

std::string name_of(const Detection& detection) {
  std::string text = fmt::format("{} {}", detection.id, to_string(detection.type));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string short_label(const Detection& detection) {
  std::string text = name_of(detection);
  const auto& dimensions = detection.dimensions;
  const std::size_t shown = std::min<std::size_t>(dimensions.size(), 3);
  for (std::size_t i = 0; i < shown; ++i) {
    const char* unit = unit_of(dimensions[i]);
    text += fmt::format(" {} {:.1f}", short_name(dimensions[i].name), shown_value(dimensions[i]));
    const bool guess = !std::isfinite(dimensions[i].std);
    // Neighbours with the same unit show it once.
    const bool last = i + 1 == shown;
    if (last || std::string(unit_of(dimensions[i + 1])) != unit) text += fmt::format(" {}", unit);
    if (guess) text += "*";
  }
  return text;
}

}  // namespace quadrille::io
