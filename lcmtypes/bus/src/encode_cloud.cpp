#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
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

/// Number of missing points that an unorganised cloud has dropped. They are added again, so that
/// the message announces as many points as the cloud's source did.
std::size_t count_dropped(const PointCloud& cloud) {
  const bool dropped = !cloud.organised() && cloud.read > cloud.points.size();
  return dropped ? cloud.read - cloud.points.size() : 0;
}

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

/// All points, followed by NaN for each dropped one.
std::vector<Eigen::Vector3f> restore_points(const PointCloud& cloud) {
  std::vector<Eigen::Vector3f> points = cloud.points;
  points.resize(points.size() + count_dropped(cloud),
                Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  return points;
}

int row_length(const PointCloud& cloud) {
  return cloud.organised() ? cloud.width
                           : static_cast<int>(cloud.points.size() + count_dropped(cloud));
}

int row_count(const PointCloud& cloud) { return cloud.organised() ? cloud.height : 1; }

bool all_finite(const PointCloud& cloud) {
  return count_dropped(cloud) == 0 &&
         std::all_of(cloud.points.begin(), cloud.points.end(),
                     [](const Eigen::Vector3f& p) { return p.allFinite(); });
}

std::vector<std::uint8_t> copy_records(const PointCloud& cloud) {
  const std::vector<Eigen::Vector3f> points = restore_points(cloud);
  std::vector<std::uint8_t> bytes(points.size() * kPointBytes);
  if (!bytes.empty()) std::memcpy(bytes.data(), points.data(), bytes.size());
  return bytes;
}

template <class Field>
Field make_field(const char* name, int offset) {
  Field field;
  field.name = name;
  field.datatype = drake::lcmt_point_cloud::FLOAT32;
  field.count = 1;
  if constexpr (requires { field.byte_offset; }) {
    field.byte_offset = offset;
  } else {
    field.offset = offset;
  }
  return field;
}

template <class Field>
std::vector<Field> make_fields() {
  return {make_field<Field>("x", 0), make_field<Field>("y", 4), make_field<Field>("z", 8)};
}

std::vector<std::byte> encode_drake(const CloudMessage& message) {
  const PointCloud& cloud = message.cloud;
  drake::lcmt_point_cloud m;
  m.utime = message.utime;
  m.frame_name = cloud.frame;
  m.width = row_length(cloud);
  m.height = row_count(cloud);
  m.num_fields = 3;
  m.fields = make_fields<drake::lcmt_point_cloud_field>();
  m.flags = (kBigEndian ? drake::lcmt_point_cloud::IS_BIGENDIAN : 0) |
            (all_finite(cloud) ? drake::lcmt_point_cloud::IS_STRICTLY_FINITE : 0);
  m.point_step = kPointBytes;
  m.row_step = m.width * kPointBytes;
  m.filler_size = 0;
  m.data = copy_records(cloud);
  m.data_size = static_cast<std::int64_t>(m.data.size());
  return encode(m);
}

std::vector<std::byte> encode_pointcloud2(const CloudMessage& message) {
  const PointCloud& cloud = message.cloud;
  bot_core::pointcloud2_t m;
  m.utime = message.utime;
  m.seq = message.seq;
  m.frame_id = cloud.frame;
  m.height = row_count(cloud);
  m.width = row_length(cloud);
  m.nfields = 3;
  m.fields = make_fields<bot_core::pointfield_t>();
  m.is_bigendian = kBigEndian;
  m.point_step = kPointBytes;
  m.row_step = m.width * kPointBytes;
  m.data = copy_records(cloud);
  m.data_nbytes = static_cast<std::int32_t>(m.data.size());
  m.is_dense = all_finite(cloud);
  return encode(m);
}

std::vector<std::byte> encode_pointcloud(const CloudMessage& message) {
  bot_core::pointcloud_t m;
  m.utime = message.utime;
  m.seq = message.seq;
  m.frame_id = message.cloud.frame;
  for (const Eigen::Vector3f& p : restore_points(message.cloud)) {
    m.points.push_back({p.x(), p.y(), p.z()});
  }
  m.n_points = static_cast<std::int32_t>(m.points.size());
  m.n_channels = 0;
  return encode(m);
}

}  // namespace

std::vector<std::byte> encode_cloud(const CloudMessage& message, CloudFormat format) {
  check_cloud(message.cloud);
  switch (format) {
    case CloudFormat::kDrake:
      return encode_drake(message);
    case CloudFormat::kPointCloud2:
      return encode_pointcloud2(message);
    case CloudFormat::kPointCloud:
      return encode_pointcloud(message);
  }
  throw std::invalid_argument("format: not a cloud format");
}

}  // namespace quadrille::bus
