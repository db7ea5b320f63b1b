#include "search/axes/profile_support.hpp"

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

/// Points about a cylinder of 50 mm radius, some of them beyond their limits and some with normals
/// that contradict it.
std::vector<ProfilePoint> some_points(int count) {
  RandomStream random(1, 0);
  std::vector<ProfilePoint> points;
  for (int i = 0; i < count; ++i) {
    const float turn = static_cast<float>(random.uniform());
    const float r = 0.05f + 0.004f * static_cast<float>(random.uniform() - 0.5);
    points.push_back({i, r, 0.1f * static_cast<float>(random.uniform()),
                      Eigen::Vector2f(std::cos(turn), std::sin(turn)), random.below(36), 0.0015f});
  }
  return points;
}

/// The sum point by point.
float sum_of(const std::vector<ProfilePoint>& points, const Profile& profile, float min_cosine) {
  float sum = 0.0f;
  for (const ProfilePoint& m : points) {
    if (!supports(m, profile, min_cosine)) continue;
    const float d = profile.distance(m) / m.limit;
    sum += 1.0f - d * d;
  }
  return sum;
}

const Profile kLine{.kind = Profile::Kind::kLine, .k = 0.02f, .r0 = 0.049f};
const Profile kArc{.kind = Profile::Kind::kArc, .c = 0.05f, .R = 0.0505f};

}  // namespace

TEST_CASE("the support of all points at once is that of one after the other", "[search][axes]") {
  for (const int count : {30, 61, 200}) {
    const std::vector<ProfilePoint> points = some_points(count);
    ProfileSupport support(points, {.min_cosine = 0.9f, .min_points = 1, .min_sectors = 1});
    const float line = sum_of(points, kLine, 0.9f), arc = sum_of(points, kArc, 0.9f);
    REQUIRE(line > 0.0f);
    REQUIRE(arc > 0.0f);
    CHECK(support.of(kLine) == line);
    // A line is preferred to an arc that fits as well.
    CHECK(support.of(kArc) == Approx(0.9f * arc));
  }
}

TEST_CASE("few points, few sectors and a sum that cannot suffice are no support",
          "[search][axes]") {
  std::vector<ProfilePoint> points = some_points(100);
  const float sum = sum_of(points, kLine, 0.9f);
  ProfileSupport many(points, {.min_cosine = 0.9f, .min_points = 101, .min_sectors = 1});
  CHECK(many.of(kLine) == 0.0f);
  ProfileSupport any(points, {.min_cosine = 0.9f, .min_points = 1, .min_sectors = 1});
  CHECK(any.of(kLine, 100.0f) == 0.0f);
  CHECK(any.of(kLine, sum - 1.0f) == sum);
  for (ProfilePoint& m : points) m.sector = 35;
  ProfileSupport narrow(points, {.min_cosine = 0.9f, .min_points = 1, .min_sectors = 2});
  CHECK(narrow.of(kLine) == 0.0f);
}
