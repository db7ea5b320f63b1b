#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "link/connection.hpp"
#include "link/receiver.hpp"
#include "link/url.hpp"
#include "process/runtime/logging.hpp"
#include "process/runtime/run.hpp"
#include "process/runtime/status/stats_file.hpp"
#include "process/runtime/watch/loss_watch.hpp"
#include "process/runtime/watch/other_senders.hpp"
#include "process/runtime/watch/silent_channels.hpp"
#include "process/runtime/worker.hpp"
#include "run/mailbox.hpp"
#include "run/rate_limiter.hpp"
#include "run/stop.hpp"

namespace quadrille {
namespace {

void hand_over(Job& job, bus::Mailbox<Job>& mailbox) {
  if (!job.refuse) {
    const std::string kind = job.kind;
    mailbox.put(std::move(job), kind);
  } else if (!mailbox.queue(job)) {
    Node::refuse(job, fmt::format("{} requests wait already", mailbox.kMaxQueued));
  }
}

/// Passes messages to a node and its jobs to the mailbox, in one order for all threads.
class Inbox {
 public:
  /// Both parameters must outlive this object.
  Inbox(Node& node, bus::Mailbox<Job>& mailbox) : node_(node), mailbox_(mailbox) {}

  void take(const std::string& channel, std::span<const std::byte> bytes) {
    const std::lock_guard lock(mutex_);
    for (Job& job : node_.take(now(), channel, bytes)) hand_over(job, mailbox_);
  }

  /// Passes on the jobs that have waited long enough.
  void take_due() {
    const std::lock_guard lock(mutex_);
    for (Job& job : node_.find_due_jobs(now())) hand_over(job, mailbox_);
  }

 private:
  static Node::Time now() {
    return std::chrono::duration_cast<Node::Time>(
        std::chrono::steady_clock::now().time_since_epoch());
  }

  Node& node_;
  bus::Mailbox<Job>& mailbox_;
  std::mutex mutex_;
};

/// Logs on which channels a process listens, and with which receive buffer, after subscribing.
/// @param url  address as it was given; the buffer in use is what the kernel grants
void log_listening(const std::vector<InChannel>& channels, const std::string& url,
                   const bus::Connection& connection) {
  const auto buffer = connection.traffic().receive_buffer;
  const std::string granted =
      buffer > 0 ? fmt::format(", with a receive buffer of {} bytes", buffer) : "";
  for (const InChannel& channel : channels) {
    log_info(fmt::format("listening to {} on {}{}", channel.name, url, granted));
  }
}

/// Listens on the channel of the node's status, if it has one.
void subscribe_to_status(const Node& node, OtherSenders& others, bus::Connection& connection) {
  for (const OutChannel& channel : node.out_channels()) {
    if (channel.option != "--status-channel") continue;
    connection.subscribe(channel.name,
                         [&](const std::string& name, std::span<const std::byte> bytes) {
                           others.hear(name, bytes);
                         });
  }
}

void publish_status(const bus::Connection& connection, const bus::Mailbox<Job>& mailbox,
                    const OtherSenders& others, StatsFile& stats, Node& node) {
  RunState run{connection.traffic(), mailbox.superseded()};
  run.warnings = LossWatch::find_warnings(run.traffic, connection.warnings());
  for (std::string& warning : others.find_warnings()) run.warnings.push_back(std::move(warning));
  stats.write(node.publish_status(run));
}

/// Publishes the last status and logs a summary.
void tell_end(const bus::Connection& connection, const bus::Mailbox<Job>& mailbox,
              const OtherSenders& others, StatsFile& stats, Node& node) {
  publish_status(connection, mailbox, others, stats, node);
  const std::string losses = LossWatch::describe(connection.traffic());
  if (!losses.empty()) log_warning("in all " + losses);
  log_info(fmt::format("stopped: {}; {} superseded", node.summary(), mailbox.superseded()));
}

void work_until_stopped(bus::Connection& connection, bus::Mailbox<Job>& mailbox,
                        const OtherSenders& others, SilentChannels& silent, StatsFile& stats,
                        Node& node, Inbox& inbox, int niceness) {
  // The first status is due after a second.
  bus::RateLimiter status_rate(std::chrono::seconds(1));
  status_rate.admit();
  LossWatch losses;
  Worker worker(mailbox, node, niceness);
  bus::Receiver receiver(connection);
  while (!bus::stop_requested()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    receiver.check();
    inbox.take_due();
    if (const auto loss = losses.check(connection.traffic())) log_warning(*loss);
    for (const std::string& line : silent.find_warnings(std::chrono::steady_clock::now())) {
      log_warning(line);
    }
    if (status_rate.admit()) publish_status(connection, mailbox, others, stats, node);
  }
  if (worker.finish(kStopPatience)) return;
  log_warning("the work at hand does not end; it is given up");
  tell_end(connection, mailbox, others, stats, node);
  // No destructor may run, because the working thread still uses all objects.
  std::_Exit(0);
}

}  // namespace

void run_on_bus(const ProcessArguments& arguments, const NodeMaker& make_node) {
  StatsFile stats(arguments.stats_file);
  const std::string url = bus::resolve_url(arguments.lcm_url);
  bus::Connection connection(url, bus::parse_senders(arguments.accept_from));
  for (const std::string& warning : connection.warnings()) log_warning(warning);
  const auto node = make_node([&](const std::string& channel, std::span<const std::byte> bytes) {
    connection.publish(channel, bytes);
  });
  bus::Mailbox<Job> mailbox;
  Inbox inbox(*node, mailbox);
  const std::vector<InChannel> in_channels = node->in_channels();
  SilentChannels silent(in_channels, std::chrono::steady_clock::now());
  for (std::size_t i = 0; i < in_channels.size(); ++i) {
    connection.subscribe(bus::ChannelPattern(in_channels[i].name),
                         [&, i](const std::string& name, std::span<const std::byte> bytes) {
                           silent.hear(i);
                           inbox.take(name, bytes);
                         });
  }
  log_listening(in_channels, url, connection);
  OtherSenders others;
  subscribe_to_status(*node, others, connection);
  work_until_stopped(connection, mailbox, others, silent, stats, *node, inbox, arguments.niceness);
  tell_end(connection, mailbox, others, stats, *node);
}

}  // namespace quadrille
