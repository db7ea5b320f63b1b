#include "io/planner/config.hpp"

#include "io/setting_reader.hpp"

namespace quadrille::io {

Config load_config(const std::string& path) {
  Config config;
  if (path.empty()) return config;
  SettingReader reader(path);
  reader.read(&config.detector);
  reader.read(&config.track);
  reader.read(&config.planner);
  reader.check("", config.detector, config.track, config.planner);
  config.given = reader.given();
  return config;
}

}  // namespace quadrille::io
