#include "config.hpp"

#include "io/toml_file.hpp"
#include "unknown_policy.hpp"

namespace quadrille {
namespace {

/// Sets one option; false if the value has the wrong type or the key is unknown.
bool set_option(const std::string& key, const toml::node& node, PlanOptions* options) {
  if (key == "unknown") {
    const auto policy = unknown_policy_from_string(node.value_or(std::string_view{}));
    if (policy) options->unknown = *policy;
    return policy.has_value();
  }
  if (key == "max_grasps") {
    const auto value = node.value_exact<std::int64_t>();
    if (value && *value >= 0 && *value <= 1000000) options->max_grasps = static_cast<int>(*value);
    return value && options->max_grasps == *value;
  }
  double* field = key == "resolution" ? &options->resolution
                  : key == "friction" ? &options->friction
                                      : nullptr;
  const auto value = node.value<double>();
  if (field == nullptr || !value) return false;
  *field = *value;
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
                              "target-shadow or free), resolution, friction and max_grasps");
    }
  }
  options.check();
  return options;
}

}  // namespace quadrille
