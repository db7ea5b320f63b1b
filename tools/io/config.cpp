#include "io/config.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>

#include "io/toml_file.hpp"
#include "io/unknown_policy.hpp"

namespace quadrille::io {
namespace {

/// Words for the values of a choice.
template <class Choice>
struct Words;
template <>
struct Words<BasisKind> {
  static constexpr std::array<std::pair<std::string_view, BasisKind>, 5> kList = {
      {{"three_points", BasisKind::kThreePoints},
       {"four_points", BasisKind::kFourPoints},
       {"nine_points", BasisKind::kNinePoints},
       {"two_points", BasisKind::kTwoPoints},
       {"sphere", BasisKind::kSphere}}};
};
template <>
struct Words<Quantisation> {
  static constexpr std::array<std::pair<std::string_view, Quantisation>, 2> kList = {
      {{"arctangent", Quantisation::kArctangent}, {"measured", Quantisation::kMeasured}}};
};

template <class Field>
concept Choice = requires {
  Words<Field>::kList;
};

template <Choice Field>
std::string words() {
  std::string list;
  for (const auto& [word, value] : Words<Field>::kList) {
    list += (list.empty() ? "" : ", ") + std::string(word);
  }
  return list;
}

template <Choice Field>
std::string_view word_of(Field field) {
  for (const auto& [word, value] : Words<Field>::kList) {
    if (value == field) return word;
  }
  return "";
}

/// Sets a field from a node; false if the node's type or range does not suit it.
template <class Field>
bool assign(const toml::node& node, Field* field) {
  if constexpr (Choice<Field>) {
    for (const auto& [word, value] : Words<Field>::kList) {
      if (node.value_or(std::string_view{}) != word) continue;
      *field = value;
      return true;
    }
    return false;
  } else if constexpr (std::is_same_v<Field, bool>) {
    const auto value = node.value_exact<bool>();
    if (value) *field = *value;
    return value.has_value();
  } else if constexpr (std::is_same_v<Field, UnknownPolicy>) {
    const auto policy = unknown_policy_from_string(node.value_or(std::string_view{}));
    if (policy) *field = *policy;
    return policy.has_value();
  } else if constexpr (std::is_floating_point_v<Field>) {
    if (!node.is_number()) return false;
    *field = *node.value<double>();
    return true;
  } else {
    const auto value = node.value_exact<std::int64_t>();
    if (!value || !std::in_range<Field>(*value)) return false;
    *field = static_cast<Field>(*value);
    return true;
  }
}

template <class Field>
std::string expected() {
  if constexpr (Choice<Field>) return "one of " + words<Field>();
  if (std::is_same_v<Field, bool>) return "true or false";
  if (std::is_same_v<Field, UnknownPolicy>) return "obstacle, target-shadow or free";
  if (std::is_floating_point_v<Field>) return "a number";
  return std::is_unsigned_v<Field> ? "a non-negative integer" : "an integer";
}

/// What may stand in the same table as a key, by its dotted name: settings and further tables; of
/// the whole file if there is no such table.
std::string neighbours_of(const std::string& name, const std::set<std::string>& known) {
  std::string table = name.substr(0, name.rfind('.') + 1);
  const auto is_inside = [&](const std::string& k) { return k.starts_with(table); };
  if (name.find('.') == std::string::npos || std::none_of(known.begin(), known.end(), is_inside)) {
    table.clear();
  }
  std::set<std::string> next;
  for (const std::string& k : known) {
    if (!is_inside(k)) continue;
    const std::size_t end = k.find('.', table.size());
    next.insert(end == std::string::npos ? k : "[" + k.substr(0, end) + "]");
  }
  std::string all;
  for (const std::string& k : next) all += (all.empty() ? "" : ", ") + k;
  return all;
}

/// Complains about the first key that is no setting.
void refuse_unknown(const toml::table& table, const std::string& prefix,
                    const std::set<std::string>& known, const std::string& path) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (known.count(name)) continue;
    if (const toml::table* inner = node.as_table()) {
      refuse_unknown(*inner, name + ".", known, path);
      continue;
    }
    throw FileError(path, line_of(node),
                    "unknown key '" + name + "'; there are " + neighbours_of(name, known));
  }
}

/// Calls visit(name, field) for each of the planner's settings, as visit_options() does for the
/// detector's.
template <class Visitor>
void visit_plan_options(PlanOptions& o, Visitor&& visit) {
  visit("planner.unknown", o.unknown);
  visit("planner.resolution", o.resolution);
  visit("planner.friction", o.friction);
  visit("planner.approach", o.approach);
  visit("planner.pad_margin", o.pad_margin);
  visit("planner.baseline", o.baseline);
  visit("planner.min_wall", o.min_wall);
  visit("planner.max_wall", o.max_wall);
  visit("planner.clear_above", o.clear_above);
  visit("planner.max_grasps", o.max_grasps);
}

}  // namespace

Settings load_settings(const std::string& path) {
  const toml::table table = read_toml(path);
  Settings settings;
  std::set<std::string> known;
  const auto read = [&](const char* name, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    known.insert(name);
    const toml::node_view<const toml::node> node = table.at_path(name);
    if (node) settings.given.insert(name);
    if (node && !assign(*node.node(), &field)) {
      throw FileError(path, line_of(*node.node()),
                      fmt::format("key '{}' must be {}", name, expected<Field>()));
    }
  };
  visit_options(settings.detector, read);
  visit_track_options(settings.track, read);
  visit_plan_options(settings.planner, read);
  refuse_unknown(table, "", known, path);
  try {
    settings.detector.check();
    settings.track.check();
    settings.planner.check();
  } catch (const std::invalid_argument& error) {
    throw FileError(path, "", error.what());
  }
  return settings;
}

std::string default_detector_config() {
  std::string text = "# Settings of the detector, with their defaults.\n";
  DetectorOptions options;
  TrackOptions track;
  const auto print = [&](const char* name, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    if constexpr (Choice<Field>) {
      text += fmt::format("{} = \"{}\"\n", name, word_of(field));
    } else if constexpr (std::is_floating_point_v<Field>) {
      text += fmt::format("{} = {:#}\n", name, field);
    } else {
      text += fmt::format("{} = {}\n", name, field);
    }
  };
  visit_options(options, print);
  visit_track_options(track, print);
  return text;
}

}  // namespace quadrille::io
