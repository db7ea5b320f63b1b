#include "log/event_log.hpp"
#include "tool.hpp"

namespace quadrille::e2e {

void rename_channel(const std::string& source, const std::string& copy, const std::string& from,
                    const std::string& to) {
  bus::LogReader reader(source);
  bus::LogWriter writer(copy);
  while (const auto event = reader.next()) {
    writer.write(event->utime, event->channel == from ? to : event->channel, event->bytes);
  }
  writer.flush();
}

}  // namespace quadrille::e2e
