#include <spdlog/spdlog.h>

#include "node.hpp"
#include "quadrille/bus/connection.hpp"
#include "quadrille/bus/mailbox.hpp"
#include "quadrille/bus/receiver.hpp"
#include "quadrille/bus/stop.hpp"
#include "quadrille/bus/ticker.hpp"
#include "quadrille/bus/url.hpp"
#include "run.hpp"

namespace quadrille {

void run_on_bus(const PlannerSettings& settings) {
  bus::Connection connection(bus::resolve_url(settings.process.lcm_url));
  for (const std::string& warning : connection.warnings()) spdlog::warn("{}", warning);
  PlannerNode node(settings, [&](const std::string& channel, std::span<const std::byte> bytes) {
    connection.publish(channel, bytes);
  });
  bus::Mailbox<CloudAndQuadrics> mailbox;
  const auto on_message = [&](const std::string& channel, std::span<const std::byte> bytes) {
    if (auto pair = node.receive(channel, bytes)) mailbox.put(std::move(*pair));
  };
  connection.subscribe(settings.cloud_channel, on_message);
  connection.subscribe(settings.quadrics_channel, on_message);
  spdlog::info("listening to {} and {} on {}", settings.cloud_channel, settings.quadrics_channel,
               connection.url());
  bus::Ticker status_tick(std::chrono::seconds(1));
  {
    bus::Receiver receiver(connection);
    while (!bus::stop_requested()) {
      if (const auto pair = mailbox.take(std::chrono::milliseconds(100))) node.handle(*pair);
      receiver.check();
      if (status_tick.due()) node.publish_status(mailbox.superseded(), connection.warnings());
    }
  }
  node.publish_status(mailbox.superseded(), connection.warnings());
  spdlog::info("stopped");
}

}  // namespace quadrille
