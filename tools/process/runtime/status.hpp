#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quadrille/bus/clock.hpp"
#include "quadrille/bus/durations.hpp"
#include "quadrille/bus/network.hpp"

namespace quadrille {

/// Sets what the status messages of all processes say of their transport, and their time.
/// @param dropped_before  bus::count_dropped_datagrams() at the start of the process
template <class Status>
void set_transport(std::int64_t superseded, const std::vector<std::string>& warnings,
                   std::int64_t dropped_before, Status* status) {
  status->utime = bus::wall_clock_utime();
  status->superseded = superseded;
  status->dropped_datagrams =
      dropped_before < 0 ? -1 : bus::count_dropped_datagrams() - dropped_before;
  status->warnings = warnings;
  status->num_warnings = static_cast<std::int32_t>(warnings.size());
}

/// Sets how long it took from a message to its answer.
template <class Status>
void set_latency(const bus::DurationSummary& latency, Status* status) {
  status->latency_p50 = latency.p50;
  status->latency_p95 = latency.p95;
  status->latency_max = latency.max;
}

}  // namespace quadrille
