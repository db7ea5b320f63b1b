#include "lab/printed/settings.hpp"

#include "io/settings/config.hpp"
#include "io/settings/setting_reader.hpp"
#include "lab/printed/printed_toml.hpp"

namespace quadrille::printed {
namespace {

Settings read(io::SettingReader reader, const std::string& path) {
  Settings settings;
  reader.read(&settings.detector);
  reader.read(&settings.printed);
  reader.check("", settings.detector, settings.printed);
  io::refuse_choice_of_types(reader.given(), path);
  return settings;
}

}  // namespace

Settings load_settings(const std::string& path) { return read(io::SettingReader(path), path); }

Settings parse_settings(std::string_view text, const std::string& path) {
  return read(io::SettingReader(text, path), path);
}

Settings printed_settings() { return parse_settings(printed_toml(), "printed.toml"); }

}  // namespace quadrille::printed
