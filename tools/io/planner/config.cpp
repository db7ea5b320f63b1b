#include "io/planner/config.hpp"

#include "io/settings/setting_reader.hpp"

namespace quadrille::io {

namespace {

Config read(SettingReader reader) {
  Config config;
  reader.read(&config.detector);
  reader.read(&config.track);
  reader.read(&config.planner);
  reader.check("", config.detector, config.track, config.planner);
  config.given = reader.given();
  return config;
}

}  // namespace

Config load_config(const std::string& path) {
  return path.empty() ? Config() : read(SettingReader(path));
}

Config parse_config(std::string_view text, const std::string& path) {
  return read(SettingReader(text, path));
}

}  // namespace quadrille::io
