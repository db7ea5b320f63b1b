#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace quadrille {

/// Returns a channel, or a pattern of channels, with the prefix of all names; an empty one stays
/// empty.
/// @throws CLI::ValidationError if LCM does not accept the name
std::string with_prefix(const std::string& prefix, const std::string& channel);

/// Checks that an address can work, or the default one if it is empty.
/// @throws CLI::ValidationError if it cannot work on any network
void check_address(const std::string& lcm_url);

/// Adds --lcm-url.
void add_address_option(CLI::App& app, std::string& lcm_url);

/// Adds --channel-prefix.
void add_prefix_option(CLI::App& app, std::string& prefix);

/// The arguments that both processes share: where to listen, or what to replay.
struct ProcessArguments {
  /// Address of the bus; if empty, LCM_DEFAULT_URL, or LCM's default.
  std::string lcm_url;
  /// Log to replay instead of listening to the bus, and log to which results are then written.
  std::string in_log, out_log;
  /// Copies all events of the replayed log to the output log.
  bool copy_input = false;
  /// Senders whose messages are received, in the form of bus::parse_senders(); if empty,
  /// everyone's.
  std::string accept_from;
  /// Prefix of the names of all channels.
  std::string channel_prefix;
  bool verbose = false;
  /// Niceness of the work, by which it yields to other processes on the bus.
  int niceness = 0;
  /// File that always holds the latest status, for node exporters; empty for none.
  std::string stats_file;

  /// Adds the options; this object must outlive the app.
  /// @param work  what is logged with --verbose, such as "cloud"
  void add_to(CLI::App& app, const std::string& work);

  /// Returns the channel with the prefix.
  /// @throws CLI::ValidationError if LCM does not accept the name
  std::string prefixed(const std::string& channel) const {
    return with_prefix(channel_prefix, channel);
  }

  /// Checks that the bus, if it is used, has an address that can work.
  /// @throws CLI::ValidationError if it has not
  void check() const;
};

/// The channel that an option names; empty for none.
struct NamedChannel {
  std::string option, name;
};

/// The direction of the messages of a channel.
enum class Way { kIn, kOut };

/// Returns the channels that visit_channels() of a process's settings lists, with their options.
template <class Settings>
std::vector<NamedChannel> channels_of(const Settings& settings) {
  std::vector<NamedChannel> channels;
  Settings::visit_channels(settings,
                           [&](Way, const char* option, const std::string& name, const char*) {
                             channels.push_back({option, name});
                           });
  return channels;
}

/// Checks that all channels are different; otherwise a message of one kind would be taken for
/// another.
/// @throws CLI::ValidationError if two are the same
void check_distinct(const std::vector<NamedChannel>& channels);

/// Checks the name of a channel that is a part of an option's value.
/// @throws CLI::ValidationError if LCM does not accept it
void check_channel(const std::string& option, const std::string& channel);

/// Adds an option that accepts the name of a channel, or a pattern of names.
/// @param what  what the channel carries, such as "clouds"
void add_pattern_option(CLI::App& app, const std::string& name, std::string& pattern,
                        const std::string& what);

/// Adds an option that accepts the name of a channel.
/// @param what  what the channel carries, such as "clouds"
void add_channel_option(CLI::App& app, const std::string& name, std::string& channel,
                        const std::string& what);

}  // namespace quadrille
