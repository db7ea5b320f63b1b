// Bodies keep their tracks while their parts, kinds and ids change.
#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "quadrille/detector/tracker.hpp"
#include "support/catch.hpp"
#include "support/exact_detection.hpp"

namespace quadrille {
namespace {

using Eigen::Vector3d;

constexpr std::int64_t kFrame = 100000;

SceneBody body_at(const Vector3d& p_C, const Vector3d& size, BodyKind kind, std::vector<int> parts,
                  int id) {
  SceneBody body;
  body.id = id;
  body.kind = kind;
  body.parts = std::move(parts);
  body.X_CB = Eigen::Translation3d(p_C);
  body.size = size;
  return body;
}

SceneBody lump_at(const Vector3d& p_C, const Vector3d& size, int id) {
  return body_at(p_C, size, BodyKind::kLump, {}, id);
}

/// A can, its radius 40 mm, as the detector tells it: a mantle alone, a mantle with a lid in either
/// order, or a lump of its seen half.
void add_can(const Vector3d& p_C, int way, DetectionResult* result) {
  const Vector3d size(0.08, 0.1, 0.08);
  const int id = 10 * (static_cast<int>(result->bodies.size()) + 1);
  Detection mantle = test::exact_cylinder(p_C, 0.04, 0.1);
  Detection lid = test::exact_plane(p_C - Vector3d(0, 0.05, 0.0), 0.08, 0.08);
  mantle.id = id;
  lid.id = id + 1;
  mantle.inliers = 900;
  lid.inliers = 300;
  if (way == 0) {
    result->detections.push_back(mantle);
    result->bodies.push_back(body_at(p_C, size, BodyKind::kSingle, {mantle.id}, mantle.id));
  } else if (way == 1) {
    result->detections.insert(result->detections.end(), {mantle, lid});
    result->bodies.push_back(
        body_at(p_C, size, BodyKind::kRevolution, {mantle.id, lid.id}, mantle.id));
  } else if (way == 2) {
    std::swap(mantle.id, lid.id);
    result->detections.insert(result->detections.end(), {lid, mantle});
    result->bodies.push_back(
        body_at(p_C, size, BodyKind::kRevolution, {lid.id, mantle.id}, lid.id));
  } else {
    const Vector3d half(0.08, 0.1, 0.04);
    result->bodies.push_back(lump_at(p_C - Vector3d(0, 0, 0.02), half, id + 5));
  }
}

/// The tracks of the bodies of each frame.
std::vector<std::vector<int>> body_tracks(int frames,
                                          const std::function<DetectionResult(int)>& frame_at) {
  Tracker tracker;
  std::vector<std::vector<int>> tracks;
  for (int k = 0; k < frames; ++k) {
    DetectionResult result = frame_at(k);
    tracker.update(kFrame * k, Eigen::Isometry3d::Identity(), &result);
    tracks.emplace_back();
    for (const SceneBody& body : result.bodies) tracks.back().push_back(body.track);
  }
  return tracks;
}

}  // namespace

TEST_CASE("a can keeps its number while its parts come and go and it turns into a lump",
          "[track][bodies]") {
  RandomStream random(7, 1);
  const auto tracks = body_tracks(40, [&](int) {
    DetectionResult result;
    add_can({0.1, 0.0, 1.0}, static_cast<int>(random.below(4)), &result);
    return result;
  });
  for (const auto& frame : tracks) CHECK(frame == tracks.front());
}

TEST_CASE("cans that stand side by side keep their numbers, in whatever order they come",
          "[track][bodies]") {
  RandomStream random(8, 1);
  // A tenth of a millimetre more than they are wide.
  const auto place = [](int n) { return Vector3d(0.0801 * n, 0.0, 1.0); };
  std::vector<int> number(4, 0);
  Tracker tracker;
  for (int k = 0; k < 40; ++k) {
    DetectionResult result;
    for (int i = 0; i < 4; ++i) {
      add_can(place((i + k) % 4), static_cast<int>(random.below(4)), &result);
    }
    tracker.update(kFrame * k, Eigen::Isometry3d::Identity(), &result);
    for (int i = 0; i < 4; ++i) {
      int& known = number[static_cast<std::size_t>((i + k) % 4)];
      if (k == 0) known = result.bodies[static_cast<std::size_t>(i)].track;
      CHECK(result.bodies[static_cast<std::size_t>(i)].track == known);
    }
  }
  CHECK(std::set<int>(number.begin(), number.end()).size() == 4);
}

TEST_CASE("a can that is carried keeps its number, although it is lost on the way",
          "[track][bodies]") {
  const auto tracks = body_tracks(30, [](int k) {
    DetectionResult result;
    // A metre in two seconds, along a can at rest.
    if (k < 12 || k > 15) add_can({-0.7 + 0.05 * k, 0.0, 0.9}, k % 4, &result);
    add_can({0.0, 0.0, 1.1}, k % 2, &result);
    return result;
  });
  for (const auto& frame : tracks) CHECK(frame.back() == tracks.front().back());
  for (const auto& frame : tracks) {
    if (frame.size() == 2) CHECK(frame.front() == tracks.front().front());
  }
}

TEST_CASE("a nut that is put where a bowl stood is another body, and so is one farther away",
          "[track][bodies]") {
  const auto tracks = body_tracks(9, [](int k) {
    DetectionResult result;
    if (k < 3) result.bodies.push_back(lump_at({0, 0, 1}, {0.3, 0.3, 0.12}, 1));
    if (k >= 3 && k < 6) result.bodies.push_back(lump_at({0, 0, 1}, {0.02, 0.02, 0.02}, 1));
    if (k >= 6) result.bodies.push_back(lump_at({0.5, 0, 1}, {0.02, 0.02, 0.02}, 1));
    return result;
  });
  for (int k = 0; k < 9; ++k) CHECK(tracks[k] == tracks[3 * (k / 3)]);
  CHECK(std::set<int>{tracks[0][0], tracks[3][0], tracks[6][0]}.size() == 3);
}

TEST_CASE("surfaces and bodies share no number, and surfaces have those that they have alone",
          "[track][bodies]") {
  Tracker tracker, alone;
  std::set<int> numbers;
  for (int k = 0; k < 5; ++k) {
    DetectionResult result;
    add_can({0.2, 0.0, 1.0}, 1, &result);
    add_can({-0.2, 0.0, 1.0}, 0, &result);
    std::vector<Detection> detections = result.detections;
    tracker.update(kFrame * k, Eigen::Isometry3d::Identity(), &result);
    alone.update(kFrame * k, Eigen::Isometry3d::Identity(), &detections);
    for (std::size_t i = 0; i < detections.size(); ++i) {
      CHECK(result.detections[i].track == detections[i].track);
      numbers.insert(detections[i].track);
    }
    for (const SceneBody& body : result.bodies) numbers.insert(body.track);
  }
  CHECK(numbers == std::set<int>{1, 2, 3, 4, 5});
}

TEST_CASE("bodies of impossible size or place are borne", "[track][bodies][hostile]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto tracks = body_tracks(3, [&](int) {
    DetectionResult result;
    result.bodies.push_back(lump_at({0, 0, 1}, {nan, 0.1, 0.1}, 1));
    result.bodies.push_back(lump_at({nan, 0, 1}, {0.1, 0.1, 0.1}, 2));
    result.bodies.push_back(lump_at({0, 0, 1}, {1e200, 0.1, 0.1}, 3));
    result.bodies.push_back(lump_at({0.5, 0, 1}, {0.1, 0.1, 0.1}, 4));
    return result;
  });
  for (const auto& frame : tracks) {
    CHECK(std::set<int>(frame.begin(), frame.end()).size() == 4);
    CHECK(frame.back() == tracks.front().back());
  }
}

}  // namespace quadrille
