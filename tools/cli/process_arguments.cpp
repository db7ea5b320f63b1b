#include "cli/process_arguments.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <stdexcept>

#include "link/channel_pattern.hpp"
#include "link/connection.hpp"
#include "link/url.hpp"

namespace quadrille {
namespace {

/// Returns what is wrong with the name of a channel; empty if LCM accepts it.
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

/// Returns what is wrong with a prefix of channel names; empty if it is valid.
std::string check_prefix(const std::string& prefix) {
  return prefix.empty() ? "" : check_channel_name(prefix);
}

/// Returns what is wrong with a list of senders; empty if it can be parsed.
std::string check_senders(const std::string& text) try {
  if (text.empty()) return "names nobody; leave it out to receive from everyone";
  bus::parse_senders(text);
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
  check_address(lcm_url);
  const std::string url = bus::resolve_url(lcm_url);
  if (!accept_from.empty() && bus::parse_url(url).provider != "udpm") {
    throw CLI::ValidationError("--accept-from", url + " does not tell senders, only udpm does");
  }
}

void check_address(const std::string& lcm_url) {
  try {
    bus::check_live(bus::parse_url(bus::resolve_url(lcm_url)));
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError(lcm_url.empty() ? "LCM_DEFAULT_URL" : "--lcm-url", error.what());
  }
}

void check_channel(const std::string& option, const std::string& channel) {
  const std::string wrong = check_channel_name(channel);
  if (!wrong.empty()) throw CLI::ValidationError(option, wrong);
}

void add_channel_option(CLI::App& app, const std::string& name, std::string& channel,
                        const std::string& what) {
  app.add_option(name, channel, "Channel of the " + what)
      ->check(CLI::Validator(check_channel_name, ""))
      ->type_name("NAME")
      ->capture_default_str();
}

void add_address_option(CLI::App& app, std::string& lcm_url) {
  app.add_option("-l,--lcm-url", lcm_url, "LCM address; else LCM_DEFAULT_URL");
}

void add_prefix_option(CLI::App& app, std::string& prefix) {
  app.add_option("--channel-prefix", prefix, "Begins the names of all channels")
      ->check(CLI::Validator(check_prefix, ""))
      ->type_name("NAME");
}

void ProcessArguments::add_to(CLI::App& app, const std::string& work) {
  add_address_option(app, lcm_url);
  app.add_option("--accept-from", accept_from,
                 "Receive only from this machine and these addresses, networks (10.0.0.0/24) and "
                 "interfaces, as they are at the start; local: from no other")
      ->check(CLI::Validator(check_senders, ""))
      ->type_name("SENDER,...");
  add_prefix_option(app, channel_prefix);
  auto* in = app.add_option("--in-log", in_log, "Replay this log, every " + work + " in order");
  auto* out = app.add_option("--out-log", out_log, "Write what is published to this log");
  auto* copy =
      app.add_flag("--copy-input", copy_input, "Copy the replayed events to the written log too");
  in->needs(out);
  out->needs(in);
  copy->needs(in);
  for (const char* live : {"--lcm-url", "--accept-from"}) in->excludes(app.get_option(live));
  app.add_flag("-v,--verbose", verbose, "Log every " + work);
  app.add_option("--stats-file", stats_file,
                 "Keep the last status in this file, as Prometheus' node exporter collects it")
      ->type_name("FILE");
}

std::string with_prefix(const std::string& prefix, const std::string& channel) {
  if (channel.empty() || prefix.empty()) return channel;
  const bool is_pattern = bus::ChannelPattern(channel).is_pattern();
  std::string name = is_pattern ? bus::pattern_of(prefix) + "(" + channel + ")" : prefix + channel;
  if (const std::string wrong = check_channel_pattern(name); !wrong.empty()) {
    throw CLI::ValidationError("--channel-prefix", wrong);
  }
  return name;
}

}  // namespace quadrille
