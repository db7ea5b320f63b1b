#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <span>
#include <string>

#include "doctor/datagram.hpp"
#include "quadrille/bus/rejection.hpp"

namespace quadrille::doctor {

/// The time in a message, and when the message had arrived as a whole [us].
struct Arrival {
  std::int64_t utime = 0, at = 0;
};

/// The poses of a camera and its clouds, as they were heard.
struct PoseArrivals {
  /// Channel of the poses.
  std::string channel;
  /// Valid poses, and whole clouds, in the order of their arrival; of very many, the last ones.
  std::deque<Arrival> poses, clouds;
  /// Number of messages on the channel that are not valid poses, and why the last one is not.
  std::int64_t refused = 0;
  bus::Rejection refusal = {};
  /// Other channels with poses; of very many, a few.
  std::set<std::string> other_channels = {};
  /// When listening began and ended [us].
  std::int64_t begin = 0, end = 0;
};

/// Records when the poses of a camera and its clouds arrive, within bounded memory.
class PoseRecorder {
 public:
  /// Limits of the poses that are kept, likewise of the clouds; of the names of other channels; and
  /// of the clouds of which only a part has arrived.
  static constexpr std::size_t kMaxArrivals = 1 << 16, kMaxNames = 16, kMaxParts = 64;

  /// @param pose_channel  channel of the poses; if it is empty, nothing is recorded
  /// @param begin  time at which listening begins [us]
  PoseRecorder(std::string pose_channel, std::string cloud_channel, std::int64_t begin);

  /// @param now  arrival time of the datagram [us]
  void add(const std::string& sender, std::span<const std::byte> datagram, std::int64_t now);

  /// Returns what was heard until now [us].
  PoseArrivals heard(std::int64_t now) const;

 private:
  /// A cloud of which a part has arrived.
  struct Part {
    std::uint32_t sequence = 0, came = 0;
    std::int64_t utime = 0;
  };

  void add_start(const std::string& sender, const Datagram& datagram, std::int64_t now);
  void add_pose(std::span<const std::byte> message, std::int64_t now);
  void add_fragment(const std::string& sender, const Datagram& datagram, std::int64_t now);

  std::string cloud_channel_;
  PoseArrivals heard_;
  std::map<std::string, Part> parts_;
};

}  // namespace quadrille::doctor
