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

void run_on_bus(const DetectorSettings& settings) {
  bus::Connection connection(bus::resolve_url(settings.process.lcm_url));
  for (const std::string& warning : connection.warnings()) spdlog::warn("{}", warning);
  DetectorNode node(settings, [&](const std::string& channel, std::span<const std::byte> bytes) {
    connection.publish(channel, bytes);
  });
  bus::Mailbox<ReceivedCloud> mailbox;
  connection.subscribe(settings.in_channel,
                       [&](const std::string&, std::span<const std::byte> bytes) {
                         if (auto cloud = node.receive(bytes)) mailbox.put(std::move(*cloud));
                       });
  spdlog::info("listening to {} on {}", settings.in_channel, connection.url());
  bus::Ticker status_tick(std::chrono::seconds(1));
  {
    bus::Receiver receiver(connection);
    while (!bus::stop_requested()) {
      if (const auto cloud = mailbox.take(std::chrono::milliseconds(100))) node.handle(*cloud);
      receiver.check();
      if (status_tick.due()) node.publish_status(mailbox.superseded(), connection.warnings());
    }
  }
  node.publish_status(mailbox.superseded(), connection.warnings());
  spdlog::info("stopped");
}

}  // namespace quadrille
