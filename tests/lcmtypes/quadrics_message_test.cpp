#include "quadrille/bus/quadrics_message.hpp"

#include "cloud_samples.hpp"
#include "found_samples.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("detections survive their message", "[bus][quadrics]") {
  const DetectionResult sent = test::make_result();
  auto decoded = decode_quadrics(encode(to_message(test::make_cloud(), sent)));
  REQUIRE(std::holds_alternative<QuadricsMessage>(decoded));
  const auto& got = std::get<QuadricsMessage>(decoded);
  CHECK(got.utime == 1234567);
  CHECK(got.seq == 42);
  CHECK(got.frame == "camera");
  REQUIRE(got.detections.size() == 2);
  for (int i = 0; i < 2; ++i) {
    const Detection &a = sent.detections[i], &b = got.detections[i];
    CHECK(b.id == a.id);
    CHECK(b.type == a.type);
    CHECK(b.Q_C.coefficients() == a.Q_C.coefficients());
    CHECK(b.score == a.score);
    CHECK(b.inliers == a.inliers);
    CHECK(b.rms == a.rms);
    CHECK(b.X_CQ.matrix() == rounded(a.X_CQ).matrix());
    REQUIRE(b.dimensions.size() == 2);
    CHECK(b.dimensions[1].name == a.dimensions[1].name);
    CHECK(b.dimensions[1].value == a.dimensions[1].value);
    CHECK(b.dimensions[1].std == a.dimensions[1].std);
    CHECK(b.extent_Q.min() == a.extent_Q.min());
    CHECK(b.extent_Q.max() == a.extent_Q.max());
    CHECK(b.seen == a.seen);
    CHECK(b.track == 7);
  }
}

TEST_CASE("the message keeps the numbers of points and the warnings", "[bus][quadrics]") {
  const quadrics_t m = to_message(test::make_cloud(), test::make_result());
  CHECK(m.points_read == 12);
  CHECK(m.points_finite == 10);
  CHECK(m.points_used == 9);
  CHECK(m.warnings == std::vector<std::string>{"few points"});
}

TEST_CASE("quadrics carry the digest of their cloud", "[bus][quadrics]") {
  CloudMessage cloud = test::make_cloud();
  cloud.digest = digest_of(cloud.cloud);
  const auto decoded = decode_quadrics(encode(to_message(cloud, test::make_result())));
  CHECK(std::get<QuadricsMessage>(decoded).cloud_digest == cloud.digest);
}

TEST_CASE("equal results give equal bytes, whatever was measured of the time", "[determinism]") {
  DetectionResult slow = test::make_result();
  slow.total_ms = 99.0;
  slow.timings = {{"vote", 98.0}};
  CHECK(encode(to_message(test::make_cloud(), slow)) == test::make_quadrics_bytes());
}

TEST_CASE("a rotation is written with one of its two quaternions", "[bus][determinism]") {
  for (const double angle : {0.1, 1.0, 3.0, 3.3, 6.0}) {
    const Eigen::Isometry3d X(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
    const pose_t pose = to_message(X);
    CHECK(pose.quaternion[0] >= 0.0);
    CHECK(from_message(pose).isApprox(X, 1e-12));
  }
}

}  // namespace
}  // namespace quadrille::bus
