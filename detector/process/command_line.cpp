#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "io/config.hpp"
#include "quadrille/bus/connection.hpp"

namespace quadrille {
namespace {

/// Options that win over the configuration file.
struct Overrides {
  std::string config;
  std::optional<std::uint64_t> seed;
  std::optional<int> threads;
  std::vector<std::string> only;
};

std::string check_channel_argument(const std::string& channel) try {
  bus::check_channel(channel);
  return {};
} catch (const std::exception& error) {
  return error.what();
}

std::string check_type_argument(const std::string& name) {
  if (quadric_type_from_string(name)) return {};
  std::string known;
  for (const QuadricType type : all_quadric_types()) known += " " + std::string(to_string(type));
  return "'" + name + "' is no type; the types are" + known;
}

void add_bus_options(CLI::App& app, DetectorSettings& settings) {
  app.add_option("-l,--lcm-url", settings.lcm_url, "LCM address; else LCM_DEFAULT_URL");
  app.add_option("--in-channel", settings.in_channel, "channel of the clouds")
      ->check(check_channel_argument)
      ->capture_default_str();
  app.add_option("--out-channel", settings.out_channel, "channel of the quadrics")
      ->check(check_channel_argument)
      ->capture_default_str();
  app.add_option("--status-channel", settings.status_channel, "channel of the status")
      ->check(check_channel_argument)
      ->capture_default_str();
}

void add_log_options(CLI::App& app, DetectorSettings& settings) {
  auto* in = app.add_option("--in-log", settings.in_log, "replay this log, every cloud in order");
  auto* out = app.add_option("--out-log", settings.out_log, "write what is published to this log");
  auto* copy = app.add_flag("--copy-input", settings.copy_input,
                            "copy the replayed events to the written log too");
  in->needs(out);
  out->needs(in);
  copy->needs(in);
  in->excludes("--lcm-url");
}

void add_detector_options(CLI::App& app, Overrides& overrides) {
  app.add_option("--config", overrides.config, "TOML file with settings of the detector")
      ->check(CLI::ExistingFile);
  app.add_option("--seed", overrides.seed, "random stream of the detector");
  app.add_option("--threads", overrides.threads, "threads of the detector; never change the result")
      ->check(CLI::Range(1, 256));
  app.add_option("--only", overrides.only, "report only these types, such as sphere,cylinder")
      ->delimiter(',')
      ->check(check_type_argument);
}

void apply(const Overrides& overrides, DetectorOptions& options) {
  if (!overrides.config.empty()) options = io::load_detector_options(overrides.config);
  if (overrides.seed) options.seed = *overrides.seed;
  if (overrides.threads) options.threads = *overrides.threads;
  if (!overrides.only.empty()) options.only.clear();
  for (const std::string& name : overrides.only) {
    options.only.push_back(quadric_type_from_string(name).value());
  }
  options.check();
}

}  // namespace

DetectorSettings parse_command_line(int argc, const char* const* argv) {
  CLI::App app("Detects quadrics in the point clouds of an LCM channel.", "quadrille-detector");
  DetectorSettings settings;
  Overrides overrides;
  add_bus_options(app, settings);
  add_log_options(app, settings);
  add_detector_options(app, overrides);
  app.add_flag("-v,--verbose", settings.verbose, "log every cloud");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Only the app can print help and errors; 0 is help, all else is wrong usage.
    std::exit(app.exit(error) == 0 ? 0 : 2);
  }
  apply(overrides, settings.detector);
  return settings;
}

}  // namespace quadrille
