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

/// All the formats, in their order.
constexpr std::array<CloudFormat, 3> all_cloud_formats() {
  return {CloudFormat::kDrake, CloudFormat::kPointCloud2, CloudFormat::kPointCloud};
}

/// "drake", "pointcloud2" or "pointcloud".
QUADRILLE_EXPORT std::string_view to_string(CloudFormat format);

/// A cloud with what its message said of it.
struct CloudMessage {
  /// Time of capture [us].
  std::int64_t utime = 0;
  /// Number of the cloud by its source; 0 where the type has none.
  std::int32_t seq = 0;
  PointCloud cloud;
  /// digest_of() the cloud; 0: not known. decode_cloud() sets it.
  std::int64_t digest = 0;
};

/// A number that tells clouds apart, whatever their utime: XXH3 of the points and of their rows and
/// columns. Never 0.
QUADRILLE_EXPORT std::int64_t digest_of(const PointCloud& cloud);

/// What the beginning of a cloud's message tells of it.
struct CloudStamp {
  /// Time of capture [us].
  std::int64_t utime = 0;
  /// Number of the cloud by its source; 0 where the type has none.
  std::int32_t seq = 0;
};

/// Reads no more than the beginning; nullopt if no cloud's message begins so.
QUADRILLE_EXPORT std::optional<CloudStamp> read_stamp(std::span<const std::byte> bytes);

/// The largest message that LCM delivers over UDP [byte].
inline constexpr std::size_t kMaxMessageBytes = std::size_t{256} << 20;

/// The longest name of a frame that is accepted [byte].
inline constexpr std::size_t kMaxFrameBytes = 1024;

/// Whether colours are read: those who detect and plan alone need none.
enum class CloudColours { kDrop, kKeep };

/// Reads a cloud out of a message of any of the formats.
///
/// Every length, sign and product is checked before anything is allocated, and memory stays within
/// three times the size of the message. The points are read as by read_points(): missing ones are
/// dropped from an unorganised cloud and kept as NaN in an organised one; the viewpoint is the
/// origin.
/// @param bytes      the message as it came, fingerprint first
/// @param max_bytes  larger messages are refused [byte]
/// @param colours    whether to keep those of a field `rgb` or `rgba` of 32 bits: in
///                   drake.lcmt_point_cloud the bytes red, green, blue, as Drake writes them; in
///                   bot_core.pointcloud2_t 0x00RRGGBB, as PCL does. Others are passed over.
QUADRILLE_EXPORT Decoded<CloudMessage> decode_cloud(std::span<const std::byte> bytes,
                                                    std::size_t max_bytes = kMaxMessageBytes,
                                                    CloudColours colours = CloudColours::kDrop);

/// The bytes of a cloud as a message: float32 x, y, z without other fields.
///
/// What was dropped from an unorganised cloud goes in again as NaN, so that the message announces
/// cloud.read points. kPointCloud cannot tell the rows of an organised cloud; no type can tell the
/// viewpoint.
/// @throws std::invalid_argument if the cloud's frame or size does not fit the type
QUADRILLE_EXPORT std::vector<std::byte> encode_cloud(const CloudMessage& message,
                                                     CloudFormat format);

}  // namespace quadrille::bus
