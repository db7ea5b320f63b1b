#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "doctor/finding.hpp"
#include "quadrille/bus/durations.hpp"
#include "quadrille/bus/url.hpp"

namespace quadrille::doctor {

/// Messages to send to oneself.
struct Trip {
  int messages = 0;
  /// Each of them [byte].
  std::size_t bytes = 0;
  std::chrono::milliseconds interval{0};
};

/// What became of them.
struct TripResult {
  int sent = 0, came = 0;
  /// From sent to received [ms].
  bus::DurationSummary latency;
};

/// Sends messages from one connection to another, both of this process. They never leave the
/// machine: their ttl is 0.
/// @throws std::runtime_error if the address cannot be reached
TripResult make_trip(bus::Url url, const Trip& trip);

/// Judges a trip; every message has to come.
/// @param check    name of the check
/// @param buffers  what mends buffers that are too small; empty if they are not
Finding check_trip(const std::string& check, const Trip& trip, const TripResult& result,
                   const std::string& buffers);

}  // namespace quadrille::doctor
