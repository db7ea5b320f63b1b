#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::bus {

/// The message types that carry clouds, told apart by their fingerprints.
enum class CloudFormat {
  kDrake,        ///< drake.lcmt_point_cloud
  kPointCloud2,  ///< bot_core.pointcloud2_t
  kPointCloud,   ///< bot_core.pointcloud_t
};

/// All formats in their order.
constexpr std::array<CloudFormat, 3> all_cloud_formats() {
  return {CloudFormat::kDrake, CloudFormat::kPointCloud2, CloudFormat::kPointCloud};
}

/// Returns "drake", "pointcloud2" or "pointcloud".
QUADRILLE_EXPORT std::string_view to_string(CloudFormat format);

/// A cloud with the stamp of its message.
struct CloudMessage {
  /// Time of capture [us].
  std::int64_t utime = 0;
  /// Number of the cloud, counted by its source; 0 if the type has none.
  std::int32_t seq = 0;
  PointCloud cloud;
  /// Result of digest_of() for the cloud, which decode_cloud() sets; 0 if not known.
  std::int64_t digest = 0;
};

/// A number that identifies a cloud regardless of its utime: XXH3 of the points and of the numbers
/// of rows and columns. It is never 0.
QUADRILLE_EXPORT std::int64_t digest_of(const PointCloud& cloud);

/// The data at the beginning of a cloud's message.
struct CloudStamp {
  /// Time of capture [us].
  std::int64_t utime = 0;
  /// Number of the cloud, counted by its source; 0 if the type has none.
  std::int32_t seq = 0;
};

/// Reads only the beginning of a message; nullopt if it is not the beginning of a cloud's message.
QUADRILLE_EXPORT std::optional<CloudStamp> read_stamp(std::span<const std::byte> bytes);

/// Size of the largest message that LCM delivers over UDP [byte].
inline constexpr std::size_t kMaxMessageBytes = std::size_t{256} << 20;

/// Length of the longest frame name that is accepted [byte].
inline constexpr std::size_t kMaxFrameBytes = 1024;

/// Whether colours are read; detection and planning do not need them.
enum class CloudColours { kDrop, kKeep };

/// Returns "drop" or "keep".
constexpr std::string_view to_string(CloudColours colours) {
  return colours == CloudColours::kDrop ? "drop" : "keep";
}

/// Reads a cloud from a message of any of the formats.
///
/// Every length, sign and product is checked before anything is allocated, and memory stays within
/// three times the size of the message. Points are read as by read_points(): missing ones are
/// dropped from an unorganised cloud and kept as NaN in an organised one; the viewpoint is the
/// origin.
/// @param bytes      the message as it came, fingerprint first
/// @param max_bytes  larger messages are refused [byte]
/// @param colours    whether to keep the colours of a 32-bit field `rgb` or `rgba`: in
///   drake.lcmt_point_cloud the bytes red, green, blue, as Drake writes them; in
///   bot_core.pointcloud2_t 0x00RRGGBB, as PCL does. Other colour fields are ignored.
/// @param unit       length of the unit of the message's coordinates [m]
QUADRILLE_EXPORT Decoded<CloudMessage> decode_cloud(std::span<const std::byte> bytes,
                                                    std::size_t max_bytes = kMaxMessageBytes,
                                                    CloudColours colours = CloudColours::kDrop,
                                                    double unit = 1.0);

/// Returns the bytes of a cloud as a message: float32 x, y, z without other fields.
///
/// Points that were dropped from an unorganised cloud are written as NaN, so that the message
/// announces cloud.read points. kPointCloud cannot express the rows of an organised cloud, and no
/// type can express the viewpoint.
/// @throws std::invalid_argument if the cloud's frame or size does not fit the type
QUADRILLE_EXPORT std::vector<std::byte> encode_cloud(const CloudMessage& message,
                                                     CloudFormat format);

}  // namespace quadrille::bus
