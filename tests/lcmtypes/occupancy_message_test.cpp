#include "quadrille/bus/occupancy_message.hpp"

#include "grasp_samples.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {

TEST_CASE("a map of space survives its message, if its voxels have a size", "[bus][occupancy]") {
  auto map = test::make_occupancy();
  CHECK(std::get<occupancy_t>(decode_occupancy(encode(map))).data == map.data);
  map.resolution = 0.0;
  CHECK(std::get<Rejection>(decode_occupancy(encode(map))).reason == RejectReason::kBadValue);
}

}  // namespace quadrille::bus
