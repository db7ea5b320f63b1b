#include "io/settings/config.hpp"

#include <type_traits>

#include "io/settings/setting_reader.hpp"

namespace quadrille::io {

namespace {

/// Copies a setting to the field of that name.
template <class Field>
void set(const std::string_view name, const Field& value, DetectorOptions* options) {
  DetectorOptions::visit(*options, [&](auto& field, const Setting& setting) {
    if constexpr (std::is_same_v<Field, std::remove_reference_t<decltype(field)>>) {
      if (setting.name == name) field = value;
    }
  });
}

DetectorConfig read(SettingReader reader) {
  DetectorConfig config;
  reader.read(&config.detector);
  reader.read(&config.track);
  reader.check("planner", config.detector, config.track);
  config.given = reader.given();
  return config;
}

}  // namespace

DetectorConfig load_detector_config(const std::string& path) {
  return path.empty() ? DetectorConfig() : read(SettingReader(path));
}

DetectorConfig parse_detector_config(std::string_view text, const std::string& path) {
  return read(SettingReader(text, path));
}

DetectorOptions search_options(const DetectorConfig& config) {
  if (config.detector.only != std::vector{QuadricType::kSphere}) return config.detector;
  DetectorOptions options = sphere_preset();
  DetectorOptions::visit(config.detector, [&](const auto& value, const Setting& setting) {
    if (config.given.contains(setting.name)) set(setting.name, value, &options);
  });
  return options;
}

void refuse_choice_of_types(const std::set<std::string>& given, const std::string& path) {
  for (const char* key : {"only", "report"}) {
    if (!given.contains(key)) continue;
    throw FileError(path, "", std::string("key '") + key + "': here surfaces of all types count");
  }
}

}  // namespace quadrille::io
