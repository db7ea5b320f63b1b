#include <cstdint>
#include <lcmtypes/bot_core/pointcloud2_t.hpp>
#include <lcmtypes/bot_core/pointcloud_t.hpp>
#include <lcmtypes/bot_core/pose_t.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <lcmtypes/drake/lcmt_viewer_draw.hpp>
#include <lcmtypes/drake/lcmt_viewer_load_robot.hpp>

#include "support/catch.hpp"

TEST_CASE("the input types have the fingerprints of those that drivers publish",
          "[lcmtypes][contract]") {
  const auto bits = [](std::int64_t hash) { return static_cast<std::uint64_t>(hash); };
  CHECK(bits(drake::lcmt_point_cloud::getHash()) == 0x17f2c128b5d25a95u);
  CHECK(bits(drake::lcmt_point_cloud_field::getHash()) == 0xd2628d58fb331b3fu);
  CHECK(bits(bot_core::pointcloud2_t::getHash()) == 0x0bcd5ce4bf5a1b4au);
  CHECK(bits(bot_core::pointfield_t::getHash()) == 0xb24e10825e0b476du);
  CHECK(bits(bot_core::pointcloud_t::getHash()) == 0x0d89dc76eb295069u);
  CHECK(bits(bot_core::pose_t::getHash()) == 0x2e16efb052b0105eu);
}

TEST_CASE("the viewer's types have the fingerprints that Meldis knows", "[lcmtypes][contract]") {
  const auto bits = [](std::int64_t hash) { return static_cast<std::uint64_t>(hash); };
  CHECK(bits(drake::lcmt_viewer_load_robot::getHash()) == 0x8987209b10aa2d39u);
  CHECK(bits(drake::lcmt_viewer_geometry_data::getHash()) == 0x5d2e34cb3257db07u);
  CHECK(bits(drake::lcmt_viewer_draw::getHash()) == 0x414f0bfe5b2f4244u);
}
