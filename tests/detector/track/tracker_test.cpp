#include "quadrille/detector/tracker.hpp"

#include <functional>
#include <set>

#include "base/random.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "support/exact_detection.hpp"

namespace quadrille {
namespace {

using Eigen::Vector3d;
using Frame = std::vector<Detection>;

constexpr std::int64_t kStep = 100000;

/// The tracks of the detections of each frame, a tenth of a second apart, for a camera at rest.
std::vector<std::vector<int>> track(int frames, const std::function<Frame(int)>& frame_at,
                                    const TrackOptions& options = {}) {
  Tracker tracker(options);
  std::vector<std::vector<int>> tracks;
  for (int k = 0; k < frames; ++k) {
    Frame frame = frame_at(k);
    tracker.update(kStep * k, Eigen::Isometry3d::Identity(), &frame);
    tracks.emplace_back();
    for (const Detection& d : frame) tracks.back().push_back(d.track);
  }
  return tracks;
}

Detection table() { return test::exact_plane({0, 0, 1.5}, 2.0, 1.0); }

TEST_CASE("a ball that moves over a table keeps its id, whatever its rank", "[track]") {
  const auto tracks = track(20, [](int k) {
    Frame frame = {table(), test::exact_ball({-0.5 + 0.05 * k, 0.1, 1.0}, 0.1)};
    if (k % 3 == 1) std::swap(frame[0], frame[1]);
    return frame;
  });
  for (int k = 0; k < 20; ++k) {
    CHECK(tracks[k] == (k % 3 == 1 ? std::vector<int>{2, 1} : std::vector<int>{1, 2}));
  }
}

TEST_CASE("a ball that passes behind something comes out with its id", "[track]") {
  const auto tracks = track(24, [](int k) {
    Frame frame = {table()};
    const bool hidden = k >= 8 && k < 16;
    if (!hidden) frame.push_back(test::exact_ball({-0.5 + 0.06 * k, 0.0, 1.0}, 0.1));
    return frame;
  });
  CHECK(tracks[7] == std::vector<int>{1, 2});
  CHECK(tracks[16] == std::vector<int>{1, 2});
  CHECK(tracks[23] == std::vector<int>{1, 2});
}

TEST_CASE("what was away for longer than is remembered gets a new id", "[track]") {
  TrackOptions options;
  options.forget_after = 0.5;
  const auto with_pause = [&](int pause) {
    return track(
               10 + pause,
               [&](int k) {
                 Frame frame = {table()};
                 if (k < 5 || k >= 5 + pause) frame.push_back(test::exact_ball({0, 0, 1}, 0.1));
                 return frame;
               },
               options)
        .back();
  };
  CHECK(with_pause(4) == std::vector<int>{1, 2});
  CHECK(with_pause(9) == std::vector<int>{1, 3});
}

TEST_CASE("frames far apart still follow each other", "[track]") {
  Tracker tracker;
  for (int k = 0; k < 5; ++k) {
    Frame frame = {table(), test::exact_ball({0.01 * k, 0, 1}, 0.1)};
    tracker.update(5000000 * k, Eigen::Isometry3d::Identity(), &frame);
    CHECK(frame[1].track == 2);
  }
}

TEST_CASE("two equal balls that cross keep their ids, though one hides the other", "[track]") {
  const auto tracks = track(21, [](int k) {
    const double x = -0.5 + 0.05 * k;
    Frame frame = {test::exact_ball({x, 0, 1.0}, 0.1)};
    // The farther one is behind the nearer one for five frames.
    if (std::abs(k - 10) > 2) frame.push_back(test::exact_ball({-x, 0.02, 1.25}, 0.1));
    return frame;
  });
  for (const auto& frame : tracks) {
    CHECK(frame == (frame.size() == 2 ? std::vector<int>{1, 2} : std::vector<int>{1}));
  }
}

TEST_CASE("two equal balls that pass at arm's length are told apart by their motion", "[track]") {
  const auto tracks = track(21, [](int k) {
    const double x = -0.5 + 0.05 * k;
    return Frame{test::exact_ball({x, 0, 1.0}, 0.05), test::exact_ball({-x, 0.02, 1.03}, 0.05)};
  });
  CHECK(tracks.back() == std::vector<int>{1, 2});
}

TEST_CASE("a surface whose type flickers keeps its id", "[track]") {
  const auto tracks = track(12, [](int k) {
    const Vector3d p(-0.1 + 0.02 * k, 0.0, 1.0);
    Frame frame = {table(), test::exact_ball(p, 0.1)};
    if (k % 3 == 1) frame[1] = test::exact_ellipsoid(p, 0.1, 0.13);
    if (k % 3 == 2) {
      // A cylinder through the middle of what is seen.
      frame[1] = test::exact_cylinder(p + Vector3d(0, 0, 0.01), 0.1, 0.08);
    }
    return frame;
  });
  for (const auto& frame : tracks) CHECK(frame == std::vector<int>{1, 2});
}

TEST_CASE("a table of which other parts are seen in each frame keeps its id", "[track]") {
  const auto tracks = track(10, [](int k) {
    return Frame{k % 2 ? test::exact_plane({-0.4, 0, 1.5}, 1.2, 1.0) : table(),
                 test::exact_plane({0, 0, 1.2}, 0.2, 0.2)};
  });
  CHECK(tracks.back() == std::vector<int>{1, 2});
}

TEST_CASE("one that takes the place of another of other size is new", "[track]") {
  const auto tracks = track(6, [](int k) {
    return Frame{test::exact_ball({0, 0, 1.0}, k < 3 ? 0.05 : 0.09)};
  });
  CHECK(tracks[2] == std::vector<int>{1});
  CHECK(tracks[3] == std::vector<int>{2});
}

TEST_CASE("of two that are alike, each stays where it is", "[track]") {
  const auto tracks = track(6, [](int k) {
    Frame frame = {test::exact_ball({0, 0, 1}, 0.05), test::exact_ball({0.12, 0, 1}, 0.05)};
    if (k % 2) std::swap(frame[0], frame[1]);
    return frame;
  });
  CHECK(tracks[4] == std::vector<int>{1, 2});
  CHECK(tracks[5] == std::vector<int>{2, 1});
}

TEST_CASE("a surface of other shape in the same place is new", "[track]") {
  const auto tracks = track(4, [](int k) {
    return Frame{k < 2 ? test::exact_plane({0, 0, 0.9}, 0.2, 0.2)
                       : test::exact_cylinder({0, 0, 1}, 0.1, 0.2)};
  });
  CHECK(tracks[1] == std::vector<int>{1});
  CHECK(tracks[3] == std::vector<int>{2});
}

TEST_CASE("dimensions tell apart what the little that is seen does not", "[track]") {
  // Caps so small that both spheres fit both; they change places between two frames.
  const auto cap = [](double x, double radius) {
    Detection ball = test::exact_ball({x, 0, 0.9 + radius}, radius);
    ball.extent_Q = {Vector3d(-0.01, -0.01, 0.9 * radius), Vector3d(0.01, 0.01, radius)};
    return ball;
  };
  const auto tracks = track(2, [&](int k) {
    const double x = k == 0 ? 0.0 : 0.03;
    return Frame{cap(x, 0.05), cap(0.03 - x, 0.1)};
  });
  CHECK(tracks[1] == std::vector<int>{1, 2});
}

TEST_CASE("what was just seen goes before what may be anywhere by now", "[track]") {
  const auto tracks = track(12, [](int k) {
    Frame frame = {test::exact_ball({k < 11 ? 0.0 : 0.02, 0, 1}, 0.05)};
    if (k < 5) frame.push_back(test::exact_ball({0.12, 0, 1}, 0.05));
    return frame;
  });
  CHECK(tracks[4] == std::vector<int>{1, 2});
  CHECK(tracks[11] == std::vector<int>{1});
}

TEST_CASE("a moving camera keeps the ids of what is at rest if its poses are given", "[track]") {
  for (const bool with_poses : {true, false}) {
    Tracker tracker;
    std::set<int> ids;
    for (int k = 0; k < 10; ++k) {
      // Around the scene and up and down, in steps of 0.4 m.
      const Eigen::Isometry3d X_WC =
          test::world_seen_from({std::cos(0.4 * k), std::sin(0.4 * k), k % 2 ? 0.7 : 0.3})
              .inverse();
      Frame frame;
      for (const Vector3d& p_W : {Vector3d(0.25, 0, 0), Vector3d(-0.25, 0.1, 0)}) {
        frame.push_back(test::exact_ball(X_WC.inverse() * p_W, 0.06));
      }
      tracker.update(kStep * k, with_poses ? X_WC : Eigen::Isometry3d::Identity(), &frame);
      ids.insert({frame[0].track, 10 + frame[1].track});
    }
    CHECK((ids == std::set<int>{1, 12}) == with_poses);
  }
}

TEST_CASE("when time runs backwards all begins anew", "[track]") {
  Tracker tracker;
  const auto at = [&](std::int64_t utime, const Frame& seen) {
    Frame frame = seen;
    tracker.update(utime, Eigen::Isometry3d::Identity(), &frame);
    return frame.back().track;
  };
  const Detection ball = test::exact_ball({0, 0, 1}, 0.1);
  CHECK(at(1000000, {table(), ball}) == 2);
  CHECK(at(1100000, {table(), ball}) == 2);
  CHECK(at(1100000, {table(), ball}) == 2);
  CHECK(at(1000000, {ball}) == 1);
  CHECK(at(1100000, {table(), ball}) == 1);
}

TEST_CASE("the same detections get the same ids, with any noise", "[track][determinism]") {
  const auto run = [] {
    RandomStream random(3, 0);
    return track(30, [&](int k) {
      Frame frame;
      for (int i = 0; i < 6; ++i) {
        Vector3d p(0.25 * i - 0.6, 0.1 * std::sin(0.3 * k + i), 1.0 + 0.1 * (i % 3));
        for (double& x : p) x += 0.003 * test::gaussian(random);
        if (random.uniform() < 0.8) frame.push_back(test::exact_ball(p, 0.05 + 0.002 * i));
      }
      return frame;
    });
  };
  const auto first = run();
  CHECK(run() == first);
  std::set<int> ids;
  for (const auto& frame : first) ids.insert(frame.begin(), frame.end());
  CHECK(ids.size() == 6);
}

TEST_CASE("without tracking no detection has a track", "[track]") {
  TrackOptions options;
  options.enabled = false;
  CHECK(track(
            1, [](int) { return Frame{table()}; }, options)[0] == std::vector<int>{0});
}

TEST_CASE("patches of one plane that lie far apart are two, however wide the gate", "[track]") {
  TrackOptions options;
  options.gate = 20.0;
  const auto last_at = [&](double x) {
    return track(
               6,
               [&](int k) {
                 return Frame{k < 5 ? test::exact_plane({0, 0, 1.5}, 1.0, 1.0)
                                    : test::exact_plane({x, 0, 1.5}, 0.1, 0.1)};
               },
               options)
        .back();
  };
  CHECK(last_at(0.4) == std::vector<int>{1});
  CHECK(last_at(1.9) == std::vector<int>{2});
}

}  // namespace
}  // namespace quadrille
