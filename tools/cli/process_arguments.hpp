#pragma once

#include <string>

namespace CLI {
class App;
}

namespace quadrille {

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
  /// Start the process anew whenever it dies.
  bool respawn = false;
  /// Begins the names of all channels.
  std::string channel_prefix;
  bool verbose = false;

  /// Adds --lcm-url, --in-log, --out-log, --copy-input, --accept-from, --respawn and
  /// --verbose; this must outlive the app.
  /// @param work  what is logged with --verbose, such as "cloud"
  void add_to(CLI::App& app, const std::string& work);

  /// Adds what concerns the bus alone: --lcm-url, --accept-from, --respawn, --channel-prefix.
  void add_bus_to(CLI::App& app);

  /// The channel with the prefix; empty stays empty.
  /// @throws CLI::ValidationError if LCM does not take the name
  std::string prefixed(const std::string& channel) const;
};

/// Adds an option that takes the name of a channel.
/// @param what  what the channel carries, such as "clouds"
void add_channel_option(CLI::App& app, const std::string& name, std::string& channel,
                        const std::string& what);

}  // namespace quadrille
