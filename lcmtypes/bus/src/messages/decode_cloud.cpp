#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <lcmtypes/bot_core/pointcloud2_t.hpp>
#include <lcmtypes/bot_core/pointcloud_t.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <new>
#include <optional>
#include <stdexcept>

#include "messages/byte_reader.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::bus {
namespace {

/// The announced shape of a cloud, not yet checked against its bytes.
struct Grid {
  std::int64_t width = 0, height = 0, point_step = 0, row_step = 0;
};

/// Location of a message's points within its bytes.
struct CloudView {
  std::int64_t utime = 0;
  std::int32_t seq = 0;
  std::string frame;
  PointLayout layout;
  std::span<const std::byte> records;
};

/// The offset of a field that packs a colour into 32 bits; nullopt for other fields.
std::optional<std::size_t> colour_offset(const std::string& name, std::int32_t offset,
                                         std::int8_t type) {
  const bool wide = type == drake::lcmt_point_cloud::FLOAT32 ||
                    type == drake::lcmt_point_cloud::UINT32 ||
                    type == drake::lcmt_point_cloud::INT32;
  if ((name != "rgb" && name != "rgba") || !wide || offset < 0) return std::nullopt;
  return static_cast<std::size_t>(offset);
}

/// Finds x, y and z among the fields, whose layout is the same in both types that hold a block of
/// bytes.
/// @return the offset of the colour, if there is one
std::optional<std::size_t> read_fields(ByteReader& reader, PointLayout* layout) {
  std::optional<std::size_t> colour;
  // A field has a name (4 + 1), an offset (4), a type (1) and a count (4).
  const std::int32_t count = reader.read_count("fields", 14);
  std::array<bool, 3> found{};
  std::array<std::int8_t, 3> types{};
  std::array<std::size_t*, 3> offsets{&layout->x, &layout->y, &layout->z};
  for (std::int32_t i = 0; i < count; ++i) {
    const std::string name = reader.read_string("field name", kMaxFrameBytes);
    const std::int32_t offset = reader.read_int32("field offset");
    const std::int8_t type = reader.read_int8("field type");
    reader.read_int32("field count");
    if (const auto found = colour_offset(name, offset, type)) colour = found;
    if (name != "x" && name != "y" && name != "z") continue;
    const std::size_t axis = static_cast<std::size_t>(name[0] - 'x');
    if (found[axis] || offset < 0) refuse(RejectReason::kBadLayout, "field " + name);
    found[axis] = true;
    types[axis] = type;
    *offsets[axis] = static_cast<std::size_t>(offset);
  }
  if (!found[0] || !found[1] || !found[2]) refuse(RejectReason::kBadLayout, "no fields x, y, z");
  if (types[0] != types[1] || types[0] != types[2] ||
      (types[0] != drake::lcmt_point_cloud::FLOAT32 &&
       types[0] != drake::lcmt_point_cloud::FLOAT64)) {
    refuse(RejectReason::kBadLayout, "x, y, z are not all float32 or all float64");
  }
  layout->scalar = types[0] == drake::lcmt_point_cloud::FLOAT64 ? PointLayout::Scalar::kFloat64
                                                                : PointLayout::Scalar::kFloat32;
  return colour;
}

/// Sets the colours' offsets if their bytes lie within the records.
void set_colour(std::size_t red, std::size_t green, std::size_t blue, PointLayout* layout) {
  if (std::max(red, blue) < layout->point_step) layout->rgb = {red, green, blue};
}

/// Sets the grid after checking that its rows neither overlap nor overflow.
void set_grid(const Grid& grid, PointLayout* layout) {
  if (grid.width < 0 || grid.height < 0 || grid.point_step < 0 || grid.row_step < 0) {
    refuse(RejectReason::kBadLength, "a negative size or step");
  }
  std::int64_t row_bytes = 0;
  if (__builtin_mul_overflow(grid.width, grid.point_step, &row_bytes)) {
    refuse(RejectReason::kBadLength, "width * point_step overflows");
  }
  if (grid.height > 1 && grid.row_step != 0 && grid.row_step < row_bytes) {
    refuse(RejectReason::kBadLayout, "rows overlap");
  }
  const bool empty = grid.width == 0 || grid.height == 0;
  layout->width = empty ? 0 : static_cast<std::size_t>(grid.width);
  layout->height = empty ? 0 : static_cast<std::size_t>(grid.height);
  layout->point_step = static_cast<std::size_t>(grid.point_step);
  layout->row_step = static_cast<std::size_t>(grid.row_step);
}

CloudView view_drake(ByteReader& reader) {
  CloudView view;
  Grid grid;
  view.utime = reader.read_int64("utime");
  view.frame = reader.read_string("frame_name", kMaxFrameBytes);
  grid.width = reader.read_int64("width");
  grid.height = reader.read_int64("height");
  const std::optional<std::size_t> colour = read_fields(reader, &view.layout);
  const std::int64_t flags = reader.read_int64("flags");
  view.layout.big_endian = (flags & drake::lcmt_point_cloud::IS_BIGENDIAN) != 0;
  grid.point_step = reader.read_int32("point_step");
  grid.row_step = reader.read_int64("row_step");
  reader.take(reader.read_int16("filler_size"), 1, "filler");
  view.records = reader.take(reader.read_int64("data_size"), 1, "data");
  set_grid(grid, &view.layout);
  // Drake writes the bytes red, green and blue in this order on any machine.
  if (colour) set_colour(*colour, *colour + 1, *colour + 2, &view.layout);
  return view;
}

CloudView view_pointcloud2(ByteReader& reader) {
  CloudView view;
  Grid grid;
  view.utime = reader.read_int64("utime");
  view.seq = reader.read_int32("seq");
  view.frame = reader.read_string("frame_id", kMaxFrameBytes);
  grid.height = reader.read_int32("height");
  grid.width = reader.read_int32("width");
  const std::optional<std::size_t> colour = read_fields(reader, &view.layout);
  view.layout.big_endian = reader.read_int8("is_bigendian") != 0;
  grid.point_step = reader.read_int32("point_step");
  grid.row_step = reader.read_int32("row_step");
  view.records = reader.take(reader.read_int32("data_nbytes"), 1, "data");
  reader.read_int8("is_dense");
  set_grid(grid, &view.layout);
  if (colour) {
    // The colour is 0x00RRGGBB as in PCL, in the byte order of the other fields.
    const bool big = view.layout.big_endian;
    set_colour(*colour + (big ? 1 : 2), *colour + (big ? 2 : 1), *colour + (big ? 3 : 0),
               &view.layout);
  }
  return view;
}

CloudView view_pointcloud(ByteReader& reader) {
  CloudView view;
  view.utime = reader.read_int64("utime");
  view.seq = reader.read_int32("seq");
  view.frame = reader.read_string("frame_id", kMaxFrameBytes);
  const std::int32_t points = reader.read_int32("n_points");
  // LCM writes the floats of an array one by one in big-endian order, so the array is a block of
  // records.
  view.records = reader.take(points, 3 * sizeof(float), "points");
  view.layout.big_endian = true;
  view.layout.width = static_cast<std::size_t>(points);
  const std::int32_t channels = reader.read_count("n_channels", 5);
  for (std::int32_t i = 0; i < channels; ++i) reader.skip_string("channel name");
  const std::int64_t row_bytes = std::int64_t{points} * static_cast<std::int64_t>(sizeof(float));
  reader.take(channels, row_bytes, "channels");
  return view;
}

CloudFormat read_format(ByteReader& reader) {
  const std::int64_t fingerprint = reader.read_int64("the fingerprint");
  if (fingerprint == drake::lcmt_point_cloud::getHash()) return CloudFormat::kDrake;
  if (fingerprint == bot_core::pointcloud2_t::getHash()) return CloudFormat::kPointCloud2;
  if (fingerprint == bot_core::pointcloud_t::getHash()) return CloudFormat::kPointCloud;
  refuse(RejectReason::kUnknownType, "not a cloud of a known type");
}

CloudView view_cloud(ByteReader& reader) {
  switch (read_format(reader)) {
    case CloudFormat::kDrake:
      return view_drake(reader);
    case CloudFormat::kPointCloud2:
      return view_pointcloud2(reader);
    default:
      return view_pointcloud(reader);
  }
}

}  // namespace

std::string_view to_string(CloudFormat format) {
  static constexpr std::array<std::string_view, 3> kNames = {"drake", "pointcloud2", "pointcloud"};
  return kNames.at(static_cast<std::size_t>(format));
}

std::optional<CloudStamp> read_stamp(std::span<const std::byte> bytes) try {
  ByteReader reader(bytes);
  const CloudFormat format = read_format(reader);
  CloudStamp stamp{reader.read_int64("utime")};
  if (format != CloudFormat::kDrake) stamp.seq = reader.read_int32("seq");
  return stamp;
} catch (const Refused&) {
  return std::nullopt;
}

Decoded<CloudMessage> decode_cloud(std::span<const std::byte> bytes, std::size_t max_bytes,
                                   CloudColours colours, double unit) try {
  if (bytes.size() > max_bytes) {
    refuse(RejectReason::kTooLarge, std::to_string(bytes.size()) + " bytes");
  }
  ByteReader reader(bytes);
  CloudView view = view_cloud(reader);
  reader.expect_end();
  if (colours == CloudColours::kDrop) view.layout.rgb.reset();
  CloudMessage message{
      view.utime, view.seq,
      read_points(view.records, view.layout, Eigen::Affine3d(Eigen::Scaling(unit)))};
  message.cloud.frame = view.frame;
  message.digest = digest_of(message.cloud);
  return message;
} catch (const Refused& refused) {
  return refused.rejection;
} catch (const std::invalid_argument& error) {
  return Rejection{RejectReason::kBadLayout, error.what()};
} catch (const std::bad_alloc&) {
  return Rejection{RejectReason::kInternal, "out of memory"};
}

}  // namespace quadrille::bus
