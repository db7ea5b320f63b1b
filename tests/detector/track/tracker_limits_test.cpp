// The tracker with input that is out of all bounds.
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "quadrille/detector/tracker.hpp"
#include "support/catch.hpp"
#include "support/exact_detection.hpp"

namespace quadrille {
namespace {

using Frame = std::vector<Detection>;

TEST_CASE("a stream of ever new surfaces does not make the tracker remember ever more",
          "[track][hostile]") {
  // Time that stands still lets no track grow old.
  const auto last_of_first = [](int strangers) {
    Tracker tracker;
    const auto show = [&](Frame frame) {
      tracker.update(1, Eigen::Isometry3d::Identity(), &frame);
      return frame.back().track;
    };
    CHECK(show({test::exact_ball({0, 0, 1}, 0.1)}) == 1);
    for (int k = 0; k < strangers; k += 20) {
      Frame frame;
      for (int i = 1; i <= 20; ++i) frame.push_back(test::exact_ball({3.0 * (k + i), 0, 1}, 0.1));
      CHECK(show(frame) == k + 21);
    }
    return show({test::exact_ball({0, 0, 1}, 0.1)});
  };
  CHECK(last_of_first(200) == 1);
  CHECK(last_of_first(400) == 402);
}

TEST_CASE("times and detections that make no sense are borne", "[track][hostile]") {
  Tracker tracker;
  using Limits = std::numeric_limits<std::int64_t>;
  for (const std::int64_t utime : {Limits::min(), Limits::max(), std::int64_t{0}, Limits::max()}) {
    Frame frame = {test::exact_plane({0, 0, 1.5}, 2.0, 1.0), Detection(),
                   test::exact_ball({0, 0, 1}, 1e-9)};
    frame[0].rms = std::numeric_limits<double>::quiet_NaN();
    frame[2].dimensions[0].std = std::numeric_limits<double>::infinity();
    tracker.update(utime, Eigen::Isometry3d::Identity(), &frame);
    std::set<int> ids;
    for (const Detection& d : frame) ids.insert(d.track);
    CHECK(ids.size() == 3);
  }
}

TEST_CASE("options of the tracker out of range are refused by name", "[track][options]") {
  const auto error_of = [](const char* name, double value) -> std::string {
    TrackOptions options;
    TrackOptions::visit(options, [&](auto& field, const Setting& setting) {
      if (std::string_view(setting.name) == name) field = value;
    });
    try {
      const Tracker tracker(options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  for (const char* name : {"track.gate", "track.forget_after", "track.speed", "track.acceleration",
                           "track.pose_age", "track.pose_wait"}) {
    INFO(name);
    CHECK(error_of(name, 1.0) == "");
    CHECK(error_of(name, -1.0).find(name) == 0);
    CHECK(error_of(name, std::numeric_limits<double>::quiet_NaN()).find(name) == 0);
  }
}

}  // namespace
}  // namespace quadrille
