#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <limits>
#include <vector>

#include "quadrille/bus/cloud_message.hpp"

namespace quadrille::test {

/// An organised cloud of 4 x 3 points, two of them missing.
inline bus::CloudMessage make_cloud() {
  bus::CloudMessage message{1234567, 42, {}};
  message.cloud.frame = "camera";
  message.cloud.width = 4;
  message.cloud.height = 3;
  message.cloud.read = 12;
  for (int i = 0; i < 12; ++i) {
    message.cloud.points.emplace_back(0.1f * i, -0.2f * i, 1.0f + 0.01f * i);
  }
  const float nan = std::numeric_limits<float>::quiet_NaN();
  message.cloud.points[5] = message.cloud.points[7] = {nan, nan, nan};
  return message;
}

/// The points of make_cloud() that are not missing, as a cloud without rows.
inline bus::CloudMessage make_unorganised_cloud() {
  bus::CloudMessage message = make_cloud();
  message.cloud.width = message.cloud.height = 0;
  std::erase_if(message.cloud.points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
  return message;
}

/// A drake message of one row of float64 records, the coordinates at odd offsets.
inline drake::lcmt_point_cloud make_wide_message(bool big_endian) {
  drake::lcmt_point_cloud m;
  m.utime = 7;
  m.frame_name = "lidar";
  m.width = 2;
  m.height = 1;
  m.point_step = 33;
  m.row_step = 66;
  m.flags = big_endian ? drake::lcmt_point_cloud::IS_BIGENDIAN : 0;
  int offset = 1;
  for (const char* name : {"z", "intensity", "x", "y"}) {
    drake::lcmt_point_cloud_field field;
    field.name = name;
    field.byte_offset = offset;
    field.datatype = drake::lcmt_point_cloud::FLOAT64;
    field.count = 1;
    m.fields.push_back(field);
    offset += 8;
  }
  m.num_fields = 4;
  m.filler = {0, 0, 0};
  m.filler_size = 3;
  m.data.assign(66, 0xee);
  m.data_size = 66;
  for (int point = 0; point < 2; ++point) {
    for (int member = 0; member < 4; ++member) {
      std::uint64_t bits = std::bit_cast<std::uint64_t>(10.0 * point + member + 0.5);
      if (big_endian != (std::endian::native == std::endian::big)) bits = __builtin_bswap64(bits);
      std::memcpy(&m.data[static_cast<std::size_t>(33 * point + 1 + 8 * member)], &bits, 8);
    }
  }
  return m;
}

}  // namespace quadrille::test
