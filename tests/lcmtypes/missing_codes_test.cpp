// Codes for missing points in messages.
#include "support/missing_codes.hpp"

#include <variant>

#include "detector/table_scene.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("codes for missing points in messages count as gaps", "[bus][cloud][hostile]") {
  const auto format = GENERATE(bus::CloudFormat::kDrake, bus::CloudFormat::kPointCloud2);
  const auto found = [&](const PointCloud& cloud) {
    const auto decoded = bus::decode_cloud(bus::encode_cloud({1, 1, cloud}, format));
    return detect(std::get<bus::CloudMessage>(decoded).cloud);
  };
  const DetectionResult truth = found(with_gaps(table_cloud()));
  REQUIRE(find(truth, QuadricType::kSphere));
  for (const float code : kMissingCodes) {
    CAPTURE(code);
    const DetectionResult result = found(with_code(table_cloud(), code));
    CHECK(numbers(result) == numbers(truth));
    CHECK(warns(result, "farther than 1 km") == std::isfinite(code));
  }
}
