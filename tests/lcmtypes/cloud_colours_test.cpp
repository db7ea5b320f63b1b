#include <cstring>
#include <lcmtypes/bot_core/pointcloud2_t.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

/// Records of x y z and four bytes of colour; the second has no point.
std::vector<std::uint8_t> records(const std::vector<std::array<std::uint8_t, 4>>& colours) {
  std::vector<std::uint8_t> data;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const float value = i == 1 ? std::numeric_limits<float>::quiet_NaN() : 1.0f + i;
    for (int axis = 0; axis < 3; ++axis) {
      const auto raw = std::bit_cast<std::array<std::uint8_t, 4>>(value);
      data.insert(data.end(), raw.begin(), raw.end());
    }
    data.insert(data.end(), colours[i].begin(), colours[i].end());
  }
  return data;
}

/// As Drake's PointCloudToLcm writes it.
drake::lcmt_point_cloud drake_message(std::int32_t colour_offset) {
  drake::lcmt_point_cloud m{};
  m.width = 3;
  m.height = 1;
  m.flags = drake::lcmt_point_cloud::IS_STRICTLY_FINITE;
  m.point_step = 16;
  m.row_step = 48;
  for (const char* name : {"x", "y", "z"}) {
    const auto offset = static_cast<std::int32_t>(4 * m.fields.size());
    m.fields.push_back({});
    m.fields.back().name = name;
    m.fields.back().byte_offset = offset;
    m.fields.back().datatype = drake::lcmt_point_cloud::FLOAT32;
    m.fields.back().count = 1;
  }
  m.fields.push_back(m.fields.back());
  m.fields.back().name = "rgb";
  m.fields.back().byte_offset = colour_offset;
  m.fields.back().datatype = drake::lcmt_point_cloud::UINT32;
  m.num_fields = 4;
  m.data = records({{10, 20, 30, 0}, {1, 1, 1, 0}, {250, 128, 7, 0}});
  m.data_size = static_cast<std::int64_t>(m.data.size());
  return m;
}

PointCloud decode(const std::vector<std::byte>& bytes, CloudColours colours) {
  auto decoded = decode_cloud(bytes, kMaxMessageBytes, colours);
  if (const auto* rejection = std::get_if<Rejection>(&decoded)) FAIL(rejection->detail);
  return std::get<CloudMessage>(std::move(decoded)).cloud;
}

TEST_CASE("the colours of Drake's clouds are red, green and blue in this order",
          "[bus][cloud][colours]") {
  const PointCloud cloud = decode(encode(drake_message(12)), CloudColours::kKeep);
  REQUIRE(cloud.points.size() == 2);
  CHECK(cloud.colours == std::vector<Rgb>{{10, 20, 30}, {250, 128, 7}});
}

TEST_CASE("who asks for no colours gets none", "[bus][cloud][colours]") {
  const PointCloud cloud = decode(encode(drake_message(12)), CloudColours::kDrop);
  CHECK(cloud.points.size() == 2);
  CHECK(cloud.colours.empty());
}

TEST_CASE("colours outside of their records are left out", "[bus][cloud][colours][hostile]") {
  for (const std::int32_t offset : {14, 16, 1 << 30, std::numeric_limits<std::int32_t>::max(), -1,
                                    std::numeric_limits<std::int32_t>::min()}) {
    CAPTURE(offset);
    const PointCloud cloud = decode(encode(drake_message(offset)), CloudColours::kKeep);
    CHECK(cloud.points.size() == 2);
    CHECK(cloud.colours.empty());
  }
}

TEST_CASE("the colours of pointcloud2 are packed as in PCL", "[bus][cloud][colours]") {
  bot_core::pointcloud2_t m{};
  const drake::lcmt_point_cloud source = drake_message(12);
  m.width = 3;
  m.height = 1;
  m.point_step = 16;
  m.row_step = 48;
  for (const auto& field : source.fields) {
    m.fields.push_back({});
    m.fields.back().name = field.name;
    m.fields.back().offset = field.byte_offset;
    m.fields.back().datatype = drake::lcmt_point_cloud::FLOAT32;
    m.fields.back().count = 1;
  }
  m.nfields = 4;
  m.data = records({{30, 20, 10, 255}, {1, 1, 1, 0}, {7, 128, 250, 0}});
  m.data_nbytes = static_cast<std::int32_t>(m.data.size());
  const PointCloud cloud = decode(encode(m), CloudColours::kKeep);
  CHECK(cloud.colours == std::vector<Rgb>{{10, 20, 30}, {250, 128, 7}});
}

}  // namespace
}  // namespace quadrille::bus
