#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace quadrille {

/// A channel, or a pattern of channels, with what begins the names of all; empty stays empty.
/// @throws CLI::ValidationError if LCM does not take the name
std::string with_prefix(const std::string& prefix, const std::string& channel);

/// Sees to it that an address, or the one that takes its place if it is empty, can work.
/// @throws CLI::ValidationError if it cannot, whatever the network
void check_address(const std::string& lcm_url);

/// Adds --lcm-url.
void add_address_option(CLI::App& app, std::string& lcm_url);

/// Adds --channel-prefix.
void add_prefix_option(CLI::App& app, std::string& prefix);

/// What both processes are told: where to listen, or what to replay.
struct ProcessArguments {
  /// Empty: LCM_DEFAULT_URL, or LCM's default.
  std::string lcm_url;
  /// Log to replay instead of the bus, and log that then takes what is published.
  std::string in_log, out_log;
  /// Copy all events of the replayed log to the other one.
  bool copy_input = false;
  /// Whose messages are received, as bus::parse_senders() reads it; empty: everyone's.
  std::string accept_from;
  /// Begins the names of all channels.
  std::string channel_prefix;
  bool verbose = false;
  /// By how much the work gives way to other processes on the bus, as nice does.
  int niceness = 0;
  /// File that always holds the last status, for node exporters; empty for none.
  std::string stats_file;

  /// Adds the options; this must outlive the app.
  /// @param work  what is logged with --verbose, such as "cloud"
  void add_to(CLI::App& app, const std::string& work);

  /// The channel with the prefix.
  /// @throws CLI::ValidationError if LCM does not take the name
  std::string prefixed(const std::string& channel) const {
    return with_prefix(channel_prefix, channel);
  }

  /// Sees to it that the bus which is used, if one is, is reached through an address that can work.
  /// @throws CLI::ValidationError if it cannot
  void check() const;
};

/// The channel that an option names; empty for none.
struct NamedChannel {
  std::string option, name;
};

/// Which way the messages of a channel go.
enum class Way { kIn, kOut };

/// The channels that the visit_channels() of a process's settings lists, with their options.
template <class Settings>
std::vector<NamedChannel> channels_of(const Settings& settings) {
  std::vector<NamedChannel> channels;
  Settings::visit_channels(settings,
                           [&](Way, const char* option, const std::string& name, const char*) {
                             channels.push_back({option, name});
                           });
  return channels;
}

/// Sees to it that no two of some channels are one: a message of one kind would be taken for
/// another.
/// @throws CLI::ValidationError if two are
void check_distinct(const std::vector<NamedChannel>& channels);

/// Adds an option that takes the name of a channel, or a pattern of names.
/// @param what  what the channel carries, such as "clouds"
void add_pattern_option(CLI::App& app, const std::string& name, std::string& pattern,
                        const std::string& what);

/// Adds an option that takes the name of a channel.
/// @param what  what the channel carries, such as "clouds"
void add_channel_option(CLI::App& app, const std::string& name, std::string& channel,
                        const std::string& what);

}  // namespace quadrille
