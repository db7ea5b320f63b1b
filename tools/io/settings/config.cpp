#include "io/settings/config.hpp"

#include "io/settings/setting_reader.hpp"

namespace quadrille::io {

namespace {

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

}  // namespace quadrille::io
