#include "io/config.hpp"

#include "io/setting_reader.hpp"

namespace quadrille::io {

DetectorConfig load_detector_config(const std::string& path) {
  DetectorConfig config;
  if (path.empty()) return config;
  SettingReader reader(path);
  reader.read(&config.detector);
  reader.read(&config.track);
  reader.check("planner", config.detector, config.track);
  config.given = reader.given();
  return config;
}

}  // namespace quadrille::io
