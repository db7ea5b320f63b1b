#pragma once

#include <cstddef>
#include <string>

#include "doctor/finding.hpp"

namespace quadrille::doctor {

/// What to look at.
struct Questions {
  /// The LCM address.
  std::string url;
  /// Or a pattern of channels, and what begins the names of all.
  std::string cloud_channel = "POINT_CLOUD", channel_prefix;
  /// A message with a cloud; 0: the largest seen on the bus, or bus::kUsualCloudBytes [byte].
  std::size_t cloud_bytes = 0;
  /// How long to listen [s].
  double seconds = 3.0;
};

/// Makes all checks that the address allows, in the order in which things have to work.
Findings examine(const Questions& questions);

}  // namespace quadrille::doctor
