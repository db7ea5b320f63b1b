#include <algorithm>
#include <bit>
#include <cstdint>
#include <lcmtypes/bot_core/pointcloud2_t.hpp>
#include <lcmtypes/bot_core/pointcloud_t.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <limits>
#include <stdexcept>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/encode.hpp"

namespace quadrille::bus {
namespace {

constexpr bool kBigEndian = std::endian::native == std::endian::big;
constexpr int kPointBytes = 3 * sizeof(float);
static_assert(sizeof(Eigen::Vector3f) == kPointBytes);

void check_cloud(const PointCloud& cloud) {
  if (cloud.frame.size() > kMaxFrameBytes) {
    throw std::invalid_argument("frame: a name of " + std::to_string(cloud.frame.size()) +
                                " bytes");
  }
  if (std::max(cloud.points.size(), cloud.read) > kMaxMessageBytes / kPointBytes) {
    throw std::invalid_argument("points: " + std::to_string(cloud.points.size()) +
                                " do not fit into one message");
  }
  if (cloud.organised() &&
      static_cast<std::size_t>(cloud.width) * static_cast<std::size_t>(cloud.height) !=
          cloud.points.size()) {
    throw std::invalid_argument("width and height contradict the number of points");
  }
}

/// Returns the cloud as its source announced it: in rows, with NaN for each missing point that an
/// unorganised cloud has dropped.
PointCloud restored(const PointCloud& cloud) {
  PointCloud whole;
  whole.frame = cloud.frame;
  whole.points = cloud.points;
  whole.width = cloud.width;
  whole.height = cloud.height;
  if (cloud.organised()) return whole;
  whole.points.resize(std::max(cloud.points.size(), cloud.read),
                      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  whole.width = static_cast<int>(whole.points.size());
  whole.height = 1;
  return whole;
}

bool all_finite(const PointCloud& cloud) {
  return std::all_of(cloud.points.begin(), cloud.points.end(),
                     [](const Eigen::Vector3f& p) { return p.allFinite(); });
}

std::vector<std::uint8_t> copy_records(const PointCloud& cloud) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(cloud.points.data());
  return {bytes, bytes + cloud.points.size() * kPointBytes};
}

/// @param offset  the member of the field's type that holds its offset
template <class Field>
std::vector<Field> make_fields(std::int32_t Field::*offset) {
  std::vector<Field> fields(3);
  for (int i = 0; i < 3; ++i) {
    Field& field = fields[static_cast<std::size_t>(i)];
    field.name = "xyz"[i];
    field.*offset = i * static_cast<int>(sizeof(float));
    field.datatype = drake::lcmt_point_cloud::FLOAT32;
    field.count = 1;
  }
  return fields;
}

std::vector<std::byte> encode_drake(const CloudMessage& message, const PointCloud& cloud) {
  drake::lcmt_point_cloud m;
  m.utime = message.utime;
  m.frame_name = cloud.frame;
  m.width = cloud.width;
  m.height = cloud.height;
  m.num_fields = 3;
  m.fields = make_fields(&drake::lcmt_point_cloud_field::byte_offset);
  m.flags = (kBigEndian ? drake::lcmt_point_cloud::IS_BIGENDIAN : 0) |
            (all_finite(cloud) ? drake::lcmt_point_cloud::IS_STRICTLY_FINITE : 0);
  m.point_step = kPointBytes;
  m.row_step = m.width * kPointBytes;
  m.filler_size = 0;
  m.data = copy_records(cloud);
  m.data_size = static_cast<std::int64_t>(m.data.size());
  return encode(m);
}

std::vector<std::byte> encode_pointcloud2(const CloudMessage& message, const PointCloud& cloud) {
  bot_core::pointcloud2_t m;
  m.utime = message.utime;
  m.seq = message.seq;
  m.frame_id = cloud.frame;
  m.height = cloud.height;
  m.width = cloud.width;
  m.nfields = 3;
  m.fields = make_fields(&bot_core::pointfield_t::offset);
  m.is_bigendian = kBigEndian;
  m.point_step = kPointBytes;
  m.row_step = m.width * kPointBytes;
  m.data = copy_records(cloud);
  m.data_nbytes = static_cast<std::int32_t>(m.data.size());
  m.is_dense = all_finite(cloud);
  return encode(m);
}

std::vector<std::byte> encode_pointcloud(const CloudMessage& message, const PointCloud& cloud) {
  bot_core::pointcloud_t m;
  m.utime = message.utime;
  m.seq = message.seq;
  m.frame_id = cloud.frame;
  for (const Eigen::Vector3f& p : cloud.points) {
    m.points.push_back({p.x(), p.y(), p.z()});
  }
  m.n_points = static_cast<std::int32_t>(m.points.size());
  m.n_channels = 0;
  return encode(m);
}

}  // namespace

std::vector<std::byte> encode_cloud(const CloudMessage& message, CloudFormat format) {
  check_cloud(message.cloud);
  const PointCloud cloud = restored(message.cloud);
  switch (format) {
    case CloudFormat::kDrake:
      return encode_drake(message, cloud);
    case CloudFormat::kPointCloud2:
      return encode_pointcloud2(message, cloud);
    case CloudFormat::kPointCloud:
      return encode_pointcloud(message, cloud);
  }
  throw std::invalid_argument("format: not a cloud format");
}

}  // namespace quadrille::bus
