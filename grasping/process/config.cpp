#include "config.hpp"

#include <stdexcept>

#include "io/toml_file.hpp"
#include "io/unknown_policy.hpp"

namespace quadrille {
namespace {

/// The option of a name that is a number; nullptr if there is none.
double PlanOptions::*number_option(const std::string& key) {
  if (key == "resolution") return &PlanOptions::resolution;
  if (key == "friction") return &PlanOptions::friction;
  if (key == "approach") return &PlanOptions::approach;
  if (key == "pad_margin") return &PlanOptions::pad_margin;
  if (key == "baseline") return &PlanOptions::baseline;
  if (key == "wall_least") return &PlanOptions::wall_least;
  if (key == "wall_most") return &PlanOptions::wall_most;
  return nullptr;
}

/// Sets one option; false if the value has the wrong type or the key is unknown.
bool set_option(const std::string& key, const toml::node& node, PlanOptions* options) {
  if (key == "unknown") {
    const auto policy = io::unknown_policy_from_string(node.value_or(std::string_view{}));
    if (policy) options->unknown = *policy;
    return policy.has_value();
  }
  if (key == "max_grasps") {
    const auto value = node.value_exact<std::int64_t>();
    if (value && *value >= 0 && *value <= 1000000) options->max_grasps = static_cast<int>(*value);
    return value && options->max_grasps == *value;
  }
  const auto field = number_option(key);
  const auto value = node.value<double>();
  if (field == nullptr || !value) return false;
  options->*field = *value;
  return true;
}

}  // namespace

PlanOptions load_plan_options(const std::string& path) {
  PlanOptions options;
  for (const auto& [key, node] : io::read_toml(path)) {
    const std::string name(key);
    if (!set_option(name, node, &options)) {
      throw io::FileError(path, io::line_of(node),
                          "'" + name +
                              "' is unknown or has a wrong value; the keys are unknown (obstacle, "
                              "target-shadow or free), resolution, friction, approach, pad_margin, "
                              "baseline, wall_least, wall_most and max_grasps");
    }
  }
  try {
    options.check();
  } catch (const std::invalid_argument& error) {
    throw io::FileError(path, "", error.what());
  }
  return options;
}

}  // namespace quadrille
