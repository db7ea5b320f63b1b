#include "cli/process_arguments.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <stdexcept>

#include "quadrille/bus/channel_pattern.hpp"
#include "quadrille/bus/connection.hpp"
#include "quadrille/bus/url.hpp"

namespace quadrille {
namespace {

/// Empty if LCM takes the name, else what is wrong with it.
std::string check_channel_name(const std::string& channel) try {
  bus::check_channel(channel);
  return {};
} catch (const std::exception& error) {
  return error.what();
}

std::string check_channel_pattern(const std::string& pattern) try {
  const bus::ChannelPattern ignored(pattern);
  return {};
} catch (const std::exception& error) {
  return error.what();
}

}  // namespace

void add_pattern_option(CLI::App& app, const std::string& name, std::string& pattern,
                        const std::string& what) {
  app.add_option(name, pattern, "Channel of the " + what + ", or a pattern of channels")
      ->check(CLI::Validator(check_channel_pattern, ""))
      ->type_name("NAME")
      ->capture_default_str();
}

void check_distinct(const std::vector<NamedChannel>& channels) {
  for (std::size_t n = 0; n < channels.size(); ++n) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto& [option, name] = channels[n];
      const std::string& other = channels[k].name;
      if (name.empty() || other.empty() || !bus::ChannelPattern(other).matches(name)) continue;
      throw CLI::ValidationError(option,
                                 "'" + name + "' is the channel of " + channels[k].option +
                                     " too; give each kind of message a channel of its own");
    }
  }
}

void ProcessArguments::check() const {
  if (!in_log.empty()) return;
  try {
    bus::check_live(bus::parse_url(bus::resolve_url(lcm_url)));
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError(lcm_url.empty() ? "LCM_DEFAULT_URL" : "--lcm-url", error.what());
  }
}

void add_channel_option(CLI::App& app, const std::string& name, std::string& channel,
                        const std::string& what) {
  app.add_option(name, channel, "Channel of the " + what)
      ->check(CLI::Validator(check_channel_name, ""))
      ->type_name("NAME")
      ->capture_default_str();
}

void ProcessArguments::add_to(CLI::App& app, const std::string& work) {
  auto* url = app.add_option("-l,--lcm-url", lcm_url, "LCM address; else LCM_DEFAULT_URL");
  auto* in = app.add_option("--in-log", in_log, "Replay this log, every " + work + " in order");
  auto* out = app.add_option("--out-log", out_log, "Write what is published to this log");
  auto* copy =
      app.add_flag("--copy-input", copy_input, "Copy the replayed events to the written log too");
  in->needs(out);
  out->needs(in);
  copy->needs(in);
  in->excludes(url);
  app.add_flag("-v,--verbose", verbose, "Log every " + work);
  app.add_option("--stats-file", stats_file,
                 "Keep the last status in this file, as Prometheus' node exporter collects it")
      ->type_name("FILE");
}

}  // namespace quadrille
