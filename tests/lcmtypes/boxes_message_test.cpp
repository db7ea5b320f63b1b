#include "quadrille/bus/boxes_message.hpp"

#include <limits>

#include "samples.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

std::vector<Box> some_boxes() {
  Box box;
  box.id = 9;
  box.faces = {3, 7};
  box.score = 0.8;
  box.X_CB = Eigen::Translation3d(0.1, -0.2, 0.9) *
             Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  box.size = {0.3, 0.2, 0.1};
  box.std = {0.001, 0.002, 0.03};
  box.seen = {true, true, false};
  box.inner_B = {Eigen::Vector3d(-0.15, -0.1, 0.05), Eigen::Vector3d(0.15, 0.1, 0.05)};
  box.outer_B = {Eigen::Vector3d(-0.15, -0.1, -0.05), Eigen::Vector3d(0.15, 0.1, 0.05)};
  Box other = box;
  other.id = 10;
  other.faces = {4};
  return {box, other};
}

std::vector<std::byte> bytes_of_boxes() {
  return encode(to_message(test::make_cloud(), some_boxes()));
}

TEST_CASE("boxes survive their message", "[bus][boxes]") {
  const auto decoded = decode_boxes(bytes_of_boxes());
  REQUIRE(std::holds_alternative<BoxesMessage>(decoded));
  const auto& got = std::get<BoxesMessage>(decoded);
  CHECK(got.utime == 1234567);
  CHECK(got.seq == 42);
  CHECK(got.frame == "camera");
  const std::vector<Box> sent = some_boxes();
  REQUIRE(got.boxes.size() == sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const Box &a = sent[i], &b = got.boxes[i];
    CHECK(b.id == a.id);
    CHECK(b.faces == a.faces);
    CHECK(b.score == a.score);
    CHECK(b.X_CB.isApprox(a.X_CB, 1e-14));
    CHECK(b.size == a.size);
    CHECK(b.std == a.std);
    CHECK(b.seen == a.seen);
    CHECK(b.inner_B.isApprox(a.inner_B, 0.0));
    CHECK(b.outer_B.isApprox(a.outer_B, 0.0));
  }
}

TEST_CASE("boxes cut short anywhere, or with bytes behind them, are refused", "[bus][hostile]") {
  std::vector<std::byte> bytes = bytes_of_boxes();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK(std::holds_alternative<Rejection>(decode_boxes(std::span(bytes).first(size))));
  }
  bytes.push_back(std::byte{0});
  CHECK(std::get<Rejection>(decode_boxes(bytes)).reason == RejectReason::kTrailingBytes);
  CHECK(std::get<Rejection>(decode_boxes(test::make_quadrics_bytes())).reason ==
        RejectReason::kUnknownType);
  CHECK(std::get<Rejection>(decode_boxes(bytes, 10)).reason == RejectReason::kTooLarge);
}

TEST_CASE("boxes with values without meaning are refused", "[bus][hostile]") {
  const double infinite = std::numeric_limits<double>::infinity();
  const auto reason = [](const boxes_t& m) {
    return std::get<Rejection>(decode_boxes(encode(m))).reason;
  };
  boxes_t m = to_message(test::make_cloud(), some_boxes());
  m.boxes[1].size[2] = infinite;
  CHECK(reason(m) == RejectReason::kBadValue);
  m = to_message(test::make_cloud(), some_boxes());
  m.boxes[0].pose.quaternion[0] = 2.0;
  CHECK(reason(m) == RejectReason::kBadValue);
}

TEST_CASE("no change of valid boxes makes the decoder crash", "[bus][hostile]") {
  const std::vector<std::byte> valid = bytes_of_boxes();
  for (std::size_t k = 0; k < valid.size(); ++k) {
    for (const int value : {0x00, 0x7f, 0x80, 0xff}) {
      std::vector<std::byte> bytes = valid;
      bytes[k] = static_cast<std::byte>(value);
      const auto decoded = decode_boxes(bytes);
      if (const auto* got = std::get_if<BoxesMessage>(&decoded)) CHECK(got->boxes.size() <= 2);
    }
  }
}

}  // namespace
}  // namespace quadrille::bus
