#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "support/choices.hpp"
#include "support/small_scene.hpp"

namespace quadrille::test {

/// Makes a cloud hostile by a list of changes.
class CloudSpoiler {
 public:
  CloudSpoiler(Choices& choices, PointCloud cloud) : choices_(choices), cloud_(std::move(cloud)) {}

  PointCloud spoil() {
    const std::size_t changes = choices_.below(7);
    for (std::size_t k = 0; k < changes; ++k) change();
    return std::move(cloud_);
  }

 private:
  void change() {
    switch (choices_.below(12)) {
      case 0:
      case 1:
        return overwrite();
      case 2:
        return scale();
      case 3:
        return move();
      case 4:
        cloud_.viewpoint[static_cast<Eigen::Index>(choices_.below(3))] = choices_.hostile();
        return;
      case 5:
        return flatten();
      case 6:
        return quantise(choices_.pick(std::array{0.01, 1e-3, 0.1, 1.0}));
      case 7:
        return make_list();
      case 8:
        return duplicate();
      case 9:
        std::reverse(cloud_.points.begin(), cloud_.points.end());
        return;
      case 10:
        cloud_.width = static_cast<int>(choices_.below(300));
        cloud_.height = static_cast<int>(choices_.below(300));
        return;
      default:
        cloud_.points.resize(std::min(cloud_.points.size(), choices_.below(2000)));
    }
  }

  /// Some pixels get a hostile number: as depth along their rays, as all or as one coordinate.
  void overwrite() {
    if (cloud_.points.empty()) return;
    const double code = choices_.hostile();
    const std::size_t kind = choices_.below(5), first = choices_.below(8000);
    const std::size_t step = choices_.pick(std::array<std::size_t, 6>{10000, 1, 2, 7, 80, 81});
    const std::size_t count = choices_.below(400);
    for (std::size_t k = 0; k <= count; ++k) {
      Eigen::Vector3f& p = cloud_.points[(first + k * step) % cloud_.points.size()];
      const Eigen::Vector3d ray = p.cast<double>() / static_cast<double>(p.z());
      if (kind == 0) p = (code * ray).cast<float>();
      if (kind == 1) p.setConstant(static_cast<float>(code));
      if (kind >= 2) p[static_cast<Eigen::Index>(kind - 2)] = static_cast<float>(code);
    }
  }

  void scale() {
    const double factor = choices_.pick(std::array{1000.0, 0.001, 1e6, 1e-6, 1e12, 1e-12, 20.0});
    for (Eigen::Vector3f& p : cloud_.points) p = (factor * p.cast<double>()).cast<float>();
    if (choices_.one_in(2)) cloud_.viewpoint *= factor;
  }

  void move() {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    const auto shift = [&] { return choices_.pick(std::array{0.0, 1e4, 30.0, -900.0, 1e7, 1e12}); };
    X.translation() << shift(), shift(), shift();
    if (choices_.one_in(2)) X.rotate(Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized()));
    for (Eigen::Vector3f& p : cloud_.points) p = (X * p.cast<double>()).cast<float>();
    if (!choices_.one_in(3)) cloud_.viewpoint = X * cloud_.viewpoint;
  }

  /// One coordinate becomes the same, or nearly, for all points.
  void flatten() {
    const auto axis = static_cast<Eigen::Index>(choices_.below(3));
    const float left = choices_.pick(std::array{0.0f, 1e-7f, 1e-3f}), value = choices_.one_in(4);
    for (Eigen::Vector3f& p : cloud_.points) p[axis] = value + left * p[axis];
  }

  void quantise(double step) {
    const auto s = static_cast<float>(step);
    for (Eigen::Vector3f& p : cloud_.points) p.z() = s * std::round(p.z() / s);
  }

  void make_list() {
    cloud_.width = cloud_.height = 0;
    if (choices_.one_in(3)) return;
    std::erase_if(cloud_.points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
  }

  void duplicate() {
    if (cloud_.points.empty()) return;
    const std::size_t count = choices_.below(4000), from = choices_.below(cloud_.points.size());
    const Eigen::Vector3f p = cloud_.points[from];
    for (std::size_t k = 0; k < count && from + k < cloud_.points.size(); ++k) {
      cloud_.points[from + k] = p;
    }
  }

  Choices& choices_;
  PointCloud cloud_;
};

/// Points in no shape: of hostile numbers, on a line, on a plane, in one place or at random.
inline PointCloud any_points(Choices& choices) {
  PointCloud cloud;
  const std::size_t count = choices.below(3000), kind = choices.below(5);
  RandomStream random(choices.below(4), 0);
  const double reach = choices.pick(std::array{0.3, 30.0, 1e-4, 1e4});
  for (std::size_t k = 0; k < count; ++k) {
    Eigen::Vector3d p(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    if (kind == 0) p << choices.hostile(), choices.hostile(), choices.hostile();
    if (kind == 1) p.y() = p.z() = p.x();
    if (kind == 2) p.z() = p.y();
    if (kind == 3) p.setZero();
    if (kind > 0) p = reach * p + Eigen::Vector3d::UnitZ();
    cloud.points.push_back(p.cast<float>());
  }
  return cloud;
}

/// A small cloud made of a fuzzer's bytes: mostly a scene that gives all stages something to do,
/// with some changes that no sensor would make.
inline PointCloud hostile_cloud(Choices& choices) {
  PointCloud cloud = choices.one_in(8) ? any_points(choices) : small_scene(choices).render();
  return CloudSpoiler(choices, std::move(cloud)).spoil();
}

}  // namespace quadrille::test
