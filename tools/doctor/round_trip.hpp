#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "doctor/finding.hpp"
#include "link/url.hpp"
#include "run/durations.hpp"

namespace quadrille::doctor {

/// Messages to send to oneself.
struct Trip {
  int messages = 0;
  /// Size of each message [byte].
  std::size_t bytes = 0;
  std::chrono::milliseconds interval{0};
};

/// The result of a trip.
struct TripResult {
  int sent = 0, came = 0;
  /// Time from sending to receiving [ms].
  bus::DurationSummary latency;
};

/// Sends messages between two connections of this process. They never leave the machine, because
/// their ttl is 0.
/// @throws std::runtime_error if the address cannot be reached
TripResult make_trip(bus::Url url, const Trip& trip);

/// Judges a trip; all messages must have arrived.
/// @param check    name of the check
/// @param buffers  the remedy for buffers that are too small; empty if they are large enough
Finding check_trip(const std::string& check, const Trip& trip, const TripResult& result,
                   const std::string& buffers);

}  // namespace quadrille::doctor
