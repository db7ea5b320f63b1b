#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "process/runtime/logging.hpp"
#include "process/runtime/run.hpp"
#include "process/runtime/worker.hpp"
#include "quadrille/bus/connection.hpp"
#include "quadrille/bus/mailbox.hpp"
#include "quadrille/bus/receiver.hpp"
#include "quadrille/bus/stop.hpp"
#include "quadrille/bus/ticker.hpp"
#include "quadrille/bus/url.hpp"

namespace quadrille {
namespace {

void hand_over(Job& job, bus::Mailbox<Job>& mailbox) {
  if (!job.refuse) {
    mailbox.put(std::move(job));
  } else if (!mailbox.queue(job)) {
    Node::refuse(job, fmt::format("{} requests wait already", mailbox.kMaxQueued));
  }
}

void work_until_stopped(bus::Connection& connection, bus::Mailbox<Job>& mailbox, Node& node) {
  bus::Ticker status_tick(std::chrono::seconds(1));
  const Worker worker(mailbox, node);
  bus::Receiver receiver(connection);
  while (!bus::stop_requested()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    receiver.check();
    if (status_tick.due()) node.publish_status(mailbox.superseded(), connection.warnings());
  }
}

}  // namespace

void run_on_bus(const ProcessArguments& arguments, const NodeMaker& make_node) {
  bus::Connection connection(bus::resolve_url(arguments.lcm_url),
                             bus::parse_senders(arguments.accept_from));
  for (const std::string& warning : connection.warnings()) log_warning(warning);
  const auto node = make_node([&](const std::string& channel, std::span<const std::byte> bytes) {
    connection.publish(channel, bytes);
  });
  bus::Mailbox<Job> mailbox;
  for (const InChannel& channel : node->in_channels()) {
    connection.subscribe(channel.name,
                         [&](const std::string& name, std::span<const std::byte> bytes) {
                           if (auto job = node->receive(name, bytes)) hand_over(*job, mailbox);
                         });
    log_info(fmt::format("listening to {} on {}", channel.name, connection.url()));
  }
  work_until_stopped(connection, mailbox, *node);
  node->publish_status(mailbox.superseded(), connection.warnings());
  log_info(fmt::format("stopped: {}; {} superseded", node->summary(), mailbox.superseded()));
}

}  // namespace quadrille
