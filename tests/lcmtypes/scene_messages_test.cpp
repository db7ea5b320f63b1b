#include "quadrille/bus/scene_messages.hpp"

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "decoders.hpp"
#include "put_int32.hpp"
#include "quadrille/bus/encode.hpp"
#include "scene_samples.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"

namespace quadrille::bus {
namespace {

using SceneBytes = std::vector<std::byte>;

/// Checks that the decoder refuses a message in which any of the chosen numbers is not finite.
template <class Message>
void check_finite_numbers(const Message& valid,
                          const std::function<std::vector<double*>(Message&)>& numbers_of,
                          Decoded<Message> (*decode)(std::span<const std::byte>)) {
  Message counted = valid;
  const std::size_t count = numbers_of(counted).size();
  CHECK_FALSE(test::refusal_in(decode(encode(valid))));
  for (std::size_t n = 0; n < count; ++n) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      CAPTURE(n, bad);
      Message message = valid;
      *numbers_of(message)[n] = bad;
      CHECK(test::refusal_in(decode(encode(message))) == RejectReason::kBadValue);
    }
  }
}

void add_numbers(collision_shape_t& shape, std::vector<double*>& to) {
  for (double& number : shape.pose.position) to.push_back(&number);
  for (double& number : shape.pose.quaternion) to.push_back(&number);
  for (double& number : shape.dimensions) to.push_back(&number);
  for (std::vector<double>& vertex : shape.vertices) {
    for (double& number : vertex) to.push_back(&number);
  }
}

bool are_same(const collision_shape_t& a, const collision_shape_t& b) {
  return encode(a) == encode(b);
}

/// Place of the first length of a list, behind the fingerprint, the time, the frame "world" and
/// `others` more bytes.
constexpr std::size_t list_at(std::size_t others) { return 8 + 8 + 4 + 6 + others; }

TEST_CASE("messages about the scene are read as they were written", "[bus][scene]") {
  const auto shapes =
      std::get<collision_shapes_t>(decode_shapes(encode(test::make_shapes_message())));
  CHECK(shapes.utime == 88);
  CHECK(shapes.frame == "world");
  REQUIRE(shapes.shapes.size() == 2);
  CHECK(are_same(shapes.shapes[0], test::make_cylinder_message()));
  CHECK(are_same(shapes.shapes[1], test::make_convex_message()));

  const auto robot = std::get<robot_t>(decode_robot(encode(test::make_robot_message())));
  CHECK(robot.utime == 99);
  CHECK(robot.frame == "world");
  CHECK(robot.padding == 0.0125);
  REQUIRE(robot.shapes.size() == 2);
  CHECK(are_same(robot.shapes[1], test::make_convex_message()));
  REQUIRE(robot.attached.size() == 1);
  CHECK(are_same(robot.attached[0], test::make_cylinder_message()));

  const auto support = std::get<support_t>(decode_support(encode(test::make_support_message())));
  CHECK(support.normal[1] == 0.6);
  CHECK(support.normal[2] == 0.8);
  CHECK(support.offset == -0.375);

  const auto forget = std::get<forget_t>(decode_forget(encode(test::make_forget_message())));
  CHECK_FALSE(forget.all);
  CHECK(forget.frame == "camera");
  CHECK(forget.region.position[2] == 0.75);
  CHECK(forget.region_size[2] == 0.5);
}

TEST_CASE("a shape of a message becomes the solid that its fields tell", "[bus][scene]") {
  const SolidShape cylinder = from_message(test::make_cylinder_message());
  CHECK(cylinder.kind == "cylinder");
  CHECK(cylinder.dimensions == std::vector<double>{0.0625, 0.1875});
  CHECK(cylinder.X_CS.translation() == Eigen::Vector3d(0.125, -0.25, 0.75));
  // The rotation about y by an angle of which half has the cosine 0.6 and the sine -0.8.
  const Eigen::Vector3d x_C = cylinder.X_CS.linear().col(0);
  CHECK(x_C.isApprox(Eigen::Vector3d(0.36 - 0.64, 0.0, 2.0 * 0.6 * 0.8)));
  const SolidShape convex = from_message(test::make_convex_message());
  REQUIRE(convex.vertices_S.size() == 4);
  CHECK(convex.vertices_S[3] == Eigen::Vector3d(0.0, 0.0, 0.5));
  CHECK(convex.faces == std::vector<int>{3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3});

  collision_shape_t wrong = test::make_cylinder_message();
  wrong.dimensions[1] = -1.0;
  CHECK(test::error_of([&] { from_message(wrong); }).find("sizes") != std::string::npos);
  wrong = test::make_convex_message();
  wrong.faces[1] = 4;
  CHECK(test::error_of([&] { from_message(wrong); }).find("vertex") != std::string::npos);
  wrong = test::make_cylinder_message();
  wrong.kind = "torus";
  CHECK(test::error_of([&] { from_message(wrong); }).find("must be sphere") != std::string::npos);
}

TEST_CASE("messages about the scene with a number that is not finite are refused",
          "[bus][scene][hostile]") {
  check_finite_numbers<collision_shapes_t>(
      test::make_shapes_message(),
      [](collision_shapes_t& m) {
        std::vector<double*> numbers;
        for (collision_shape_t& shape : m.shapes) add_numbers(shape, numbers);
        return numbers;
      },
      decode_shapes);
  check_finite_numbers<robot_t>(
      test::make_robot_message(),
      [](robot_t& m) {
        std::vector<double*> numbers = {&m.padding};
        for (collision_shape_t& shape : m.shapes) add_numbers(shape, numbers);
        for (collision_shape_t& shape : m.attached) add_numbers(shape, numbers);
        return numbers;
      },
      decode_robot);
  check_finite_numbers<support_t>(
      test::make_support_message(),
      [](support_t& m) {
        return std::vector<double*>{m.normal, m.normal + 1, m.normal + 2, &m.offset};
      },
      decode_support);
  check_finite_numbers<forget_t>(
      test::make_forget_message(),
      [](forget_t& m) {
        std::vector<double*> numbers;
        for (double& number : m.region.position) numbers.push_back(&number);
        for (double& number : m.region.quaternion) numbers.push_back(&number);
        for (double& number : m.region_size) numbers.push_back(&number);
        return numbers;
      },
      decode_forget);
}

TEST_CASE("directions that are no unit vectors and regions without a size are refused",
          "[bus][scene][hostile]") {
  support_t support = test::make_support_message();
  support.normal[2] = 0.9;
  CHECK(test::refusal_in(decode_support(encode(support))) == RejectReason::kBadValue);
  // This withdraws the plane.
  support.normal[0] = support.normal[1] = support.normal[2] = 0.0;
  CHECK_FALSE(test::refusal_in(decode_support(encode(support))));
  robot_t robot = test::make_robot_message();
  robot.attached[0].pose.quaternion[0] = 1.0;
  CHECK(test::refusal_in(decode_robot(encode(robot))) == RejectReason::kBadValue);
  for (int k = 0; k < 3; ++k) {
    for (const double size : {0.0, -0.125}) {
      forget_t forget = test::make_forget_message();
      forget.region_size[k] = size;
      CHECK(test::refusal_in(decode_forget(encode(forget))) == RejectReason::kBadValue);
    }
  }
}

TEST_CASE("a message that forgets all has no need of a region", "[bus][scene]") {
  forget_t forget{};
  forget.all = 1;
  forget.region_size[1] = -1.0;
  forget.region.position[0] = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(test::refusal_in(decode_forget(encode(forget))));
  forget.all = 0;
  CHECK(test::refusal_in(decode_forget(encode(forget))) == RejectReason::kBadValue);
}

TEST_CASE("lists of shapes whose lengths are negative or beyond the message are refused",
          "[bus][scene][hostile]") {
  const std::int32_t count =
      GENERATE(-1, std::numeric_limits<std::int32_t>::min(), 3, 0x40000001, 0x15555556, 0x7fffffff);
  CAPTURE(count);
  const auto changed = [&](SceneBytes bytes, std::size_t at, std::int32_t was) {
    // The number that is to be changed is where this test says.
    REQUIRE(std::to_integer<int>(bytes[at + 3]) == was);
    test::put_int32(bytes, at, count);
    return bytes;
  };
  const SceneBytes shapes = encode(test::make_shapes_message());
  CHECK(test::refusal_in(decode_shapes(changed(shapes, list_at(4), 2))));
  const SceneBytes robot = encode(test::make_robot_message());
  CHECK(test::refusal_in(decode_robot(changed(robot, list_at(8), 2))));
  // The lists of its first shape: behind the number of shapes, the target, the kind and the pose.
  const std::size_t dimensions = list_at(8) + 4 + 4 + 4 + 9 + 56;
  CHECK(test::refusal_in(decode_robot(changed(robot, dimensions, 2))));
  const std::size_t vertices = dimensions + 4 + 2 * 8;
  CHECK(test::refusal_in(decode_robot(changed(robot, vertices, 0))));
  CHECK(test::refusal_in(decode_robot(changed(robot, vertices + 4, 0))));
}

TEST_CASE("more shapes or corners than points can be compared with are refused",
          "[bus][scene][hostile]") {
  robot_t robot = test::make_robot_message();
  const auto with_shapes = [&](int count) {
    robot.shapes.assign(static_cast<std::size_t>(count), test::make_robot_message().shapes[0]);
    robot.num_shapes = count;
    return test::refusal_in(decode_robot(encode(robot)));
  };
  CHECK_FALSE(with_shapes(kMaxShapes));
  CHECK(with_shapes(kMaxShapes + 1) == RejectReason::kTooLarge);
  robot = test::make_robot_message();
  const auto with_vertices = [&](int count) {
    robot.shapes[0].vertices.assign(static_cast<std::size_t>(count), {0.0, 0.0, 0.1});
    robot.shapes[0].num_vertices = count;
    return test::refusal_in(decode_robot(encode(robot)));
  };
  CHECK_FALSE(with_vertices(kMaxVertices));
  CHECK(with_vertices(kMaxVertices + 1) == RejectReason::kTooLarge);
}

TEST_CASE("a robot of millions of empty shapes is refused by its size", "[bus][scene][hostile]") {
  const auto enlarged = [](const auto& message) {
    SceneBytes bytes = encode(message);
    bytes.resize(kMaxSceneBytes + 1);
    return bytes;
  };
  CHECK(test::refusal_in(decode_robot(enlarged(robot_t{}))) == RejectReason::kTooLarge);
  CHECK(test::refusal_in(decode_shapes(enlarged(collision_shapes_t{}))) == RejectReason::kTooLarge);
  CHECK(test::refusal_in(decode_support(enlarged(support_t{}))) == RejectReason::kTooLarge);
  CHECK(test::refusal_in(decode_forget(enlarged(forget_t{}))) == RejectReason::kTooLarge);
}

}  // namespace
}  // namespace quadrille::bus
