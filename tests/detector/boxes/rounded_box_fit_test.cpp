#include "boxes/rounded_box_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "boxes/rounded_box.hpp"
#include "rounded_patches.hpp"
#include "support/catch.hpp"
#include "walked_edge.hpp"

namespace quadrille {
namespace {

const Eigen::AlignedBox3d kTrueBox{Eigen::Vector3d(0.10, 0.12, 0.60),
                                   Eigen::Vector3d(0.20, 0.19, 0.68)};

/// A box along the axes of the camera that shows it the lower sides of its three axes.
class SeenBox {
 public:
  SeenBox(double radius, double noise)
      : cloud_(test::render(patches(radius), {640, 480, 1.0 / 600.0, noise / 0.41})),
        sight_(cloud_) {
    draft_.sight = &sight_;
    for (int axis = 0; axis < 3; ++axis) {
      Face& face = faces_[axis];
      face.n_C = -Eigen::Vector3d::Unit(axis);
      face.offset = -kTrueBox.min()[axis];
      face.sigma = noise;
      face.middle_C = kTrueBox.center();
      face.middle_C[axis] = kTrueBox.min()[axis];
      draft_.faces.push_back(&face);
      ends[axis][0] = {-kTrueBox.min()[axis], 0.0005, true};
    }
    for (const Eigen::Vector3f& p : cloud_.points) {
      if (p.allFinite()) draft_.around_C.push_back(p.cast<double>());
    }
    for (int axis = 0; axis < 3; ++axis) add_outlines(axis, radius);
  }

  double fit() { return fit_rounded_box(draft_, outlines, &ends); }
  /// The largest error of an end [m].
  double error() const {
    const Eigen::AlignedBox3d box_A = seen_part(ends);
    return std::max((box_A.min() - kTrueBox.min()).cwiseAbs().maxCoeff(),
                    (box_A.max() - kTrueBox.max()).cwiseAbs().maxCoeff());
  }
  BoxDraft& draft() { return draft_; }

  std::vector<Outline> outlines;
  BoxEnds ends;

 private:
  static std::vector<test::Patch> patches(double radius) {
    const Eigen::Isometry3d X_CB(Eigen::Translation3d(kTrueBox.center()));
    return radius > 0.0 ? test::rounded_box(X_CB, kTrueBox.sizes(), radius)
                        : test::box(X_CB, kTrueBox.sizes());
  }

  /// Adds the outlines of the upper end of an axis where an eye sees them.
  void add_outlines(int axis, double radius) {
    double& at = ends[axis][1].at;
    for (int side = 0; side < 3; ++side) {
      if (side == axis) continue;
      Outline outline{&faces_[side], axis, 1, Eigen::Vector3d::Unit(axis), {}};
      const double hidden = radius - test::shown_by_walking(outline, radius);
      outline.edge = {kTrueBox.max()[axis] - hidden, 0.0005, true};
      outlines.push_back(outline);
      at += 0.5 * outline.edge.at;
    }
    ends[axis][1].std = 0.0005;
    ends[axis][1].seen = true;
  }

  PointCloud cloud_;
  DirectionIndex sight_;
  std::array<Face, 3> faces_;
  BoxDraft draft_;
};

TEST_CASE("the derivatives of a point's distance are those of finite differences", "[boxes]") {
  RandomStream random(3, 0);
  constexpr double kStep = 1e-6;
  for (const double radius : {0.0, 0.004, 0.015}) {
    const RoundedBox box{kTrueBox, radius};
    for (int n = 0; n < 200; ++n) {
      Eigen::Vector3d p;
      for (int k = 0; k < 3; ++k) {
        p[k] = kTrueBox.min()[k] + (1.4 * random.uniform() - 0.2) * kTrueBox.sizes()[k];
      }
      // Points that are equally near to two sides are left out: the distance has no derivative
      // there.
      Eigen::Vector3d beyond = box.beyond_ends(p);
      std::sort(beyond.begin(), beyond.end());
      if (beyond[2] < -radius && beyond[2] - beyond[1] < 10.0 * kStep) continue;
      if ((beyond.array() + radius).abs().minCoeff() < 10.0 * kStep) continue;
      const auto derivatives = box.derivatives(p);
      for (int k = 0; k < 7; ++k) {
        const auto distance = [&](double step) {
          RoundedBox moved = box;
          if (k == 6) {
            moved.radius += step;
          } else {
            (k % 2 ? moved.box_A.max() : moved.box_A.min())[k / 2] += k % 2 ? step : -step;
          }
          return moved.distance(p);
        };
        // Without a radius, edges that are rounded less than sharply do not exist.
        if (k == 6 && radius == 0.0) continue;
        const double difference = (distance(kStep) - distance(-kStep)) / (2.0 * kStep);
        INFO("radius " << radius << ", unknown " << k << ", at " << beyond.transpose());
        CHECK(derivatives[k] == Approx(difference).margin(1e-5));
      }
    }
  }
}

TEST_CASE("the fit finds the ends and the radius of a rounded box that is seen from one side",
          "[boxes]") {
  for (const double radius : {0.0, 0.005, 0.015}) {
    for (const double noise : {0.0, 0.0005, 0.001}) {
      SeenBox box(radius, noise);
      const double fitted = box.fit();
      INFO("radius " << radius << ", noise " << noise << ", fitted " << fitted << ", error "
                     << box.error());
      CHECK(std::abs(fitted - radius) < 0.001);
      CHECK(box.error() < 0.001);
    }
  }
}

TEST_CASE("an end that rests on a plane stays where it is, and its outlines count for nothing",
          "[boxes]") {
  SeenBox box(0.005, 0.0005);
  box.ends[1][1].at = kTrueBox.max().y();
  box.ends[1][1].rests = true;
  for (Outline& outline : box.outlines) {
    if (outline.axis == 1) outline.edge.at += 0.05;
  }
  box.fit();
  CHECK(box.ends[1][1].at == kTrueBox.max().y());
  CHECK(box.error() < 0.001);
}

TEST_CASE("without points about its edges a box has sharp ones, at its outlines", "[boxes]") {
  SeenBox box(0.0, 0.0005);
  box.draft().around_C.clear();
  CHECK(box.fit() == Approx(0.0).margin(1e-6));
  CHECK(box.error() < 1e-4);
}

TEST_CASE("without outlines all ends of a box stay", "[boxes]") {
  SeenBox box(0.005, 0.0005);
  box.outlines.clear();
  const BoxEnds before = box.ends;
  box.fit();
  for (int k = 0; k < 6; ++k) CHECK(box.ends[k / 2][k % 2].at == before[k / 2][k % 2].at);
}

TEST_CASE("a flat box without any size has neither a radius nor room for one", "[boxes]") {
  SeenBox box(0.0, 0.0005);
  box.ends[2][1].at = -box.ends[2][0].at;
  CHECK(box.fit() < 0.001);
}

TEST_CASE("points that are not finite count for nothing", "[boxes]") {
  SeenBox box(0.005, 0.0005), with_nan(0.005, 0.0005);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(nan, 0.12, 0.6), Eigen::Vector3d(0.1, nan, 0.6),
                                   Eigen::Vector3d(nan, nan, nan)}) {
    with_nan.draft().around_C.push_back(p);
  }
  const double radius = box.fit();
  CHECK(with_nan.fit() == Approx(radius).margin(1e-5));
  CHECK(with_nan.error() < 0.001);
}

TEST_CASE("an outline that is not finite spoils its end, so that the box is refused", "[boxes]") {
  SeenBox box(0.0, 0.0005);
  for (Outline& outline : box.outlines) {
    if (outline.axis == 0) outline.edge.at = std::numeric_limits<double>::quiet_NaN();
  }
  box.fit();
  CHECK(!(box.ends[0][1].at < 1.0 && box.ends[0][1].std < 0.1));
}

}  // namespace
}  // namespace quadrille
