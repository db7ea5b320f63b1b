#pragma once

#include <cstdint>
#include <lcmtypes/quadrille/transport_t.hpp>
#include <string>
#include <vector>

#include "process/runtime/process_info.hpp"
#include "process/runtime/rate.hpp"
#include "process/runtime/stages.hpp"
#include "quadrille/bus/clock.hpp"
#include "quadrille/bus/connection.hpp"

namespace quadrille {

/// What the status messages say of the way of the messages into the process.
transport_t to_message(const bus::Traffic& traffic);

/// What the status messages of all processes have in common, and what it comes from.
struct CommonStatus {
  bus::Traffic traffic;
  /// Jobs dropped for a newer one.
  std::int64_t superseded = 0;
  /// What is wrong with the transport.
  std::vector<std::string> warnings;
  /// SettingsText::hash()
  std::string settings;

  template <class Status>
  void write_to(Status* status) const {
    status->utime = bus::wall_clock_utime();
    status->superseded = superseded;
    status->transport = to_message(traffic);
    status->process = describe_process(settings);
    status->warnings = warnings;
    status->num_warnings = static_cast<std::int32_t>(warnings.size());
  }
};

template <class Status>
void set_stages(const Stages& stages, Status* status) {
  status->stages = stages.to_message();
  status->num_stages = static_cast<std::int32_t>(status->stages.size());
}

}  // namespace quadrille
