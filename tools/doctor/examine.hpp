#pragma once

#include <cstddef>
#include <string>

#include "doctor/finding.hpp"

namespace quadrille::doctor {

/// The subject of an examination.
struct Questions {
  /// The LCM address.
  std::string url;
  /// Channel of the clouds, or a pattern of channels; and the prefix of all names.
  std::string cloud_channel = "POINT_CLOUD", channel_prefix;
  /// Channel of the camera's poses; empty if they are not to be checked.
  std::string pose_channel = {};
  /// Size of a message with a cloud [byte]; 0 for the largest one seen on the bus, or
  /// bus::kUsualCloudBytes.
  std::size_t cloud_bytes = 0;
  /// Time to listen [s].
  double seconds = 3.0;
};

/// Runs all checks that make sense for the address, from the network up.
Findings examine(const Questions& questions);

}  // namespace quadrille::doctor
