#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace quadrille {

/// Red, green and blue, 0 to 1.
using Color = Eigen::Vector3f;

/// An RGB image, row by row from the top.
class Image {
 public:
  Image(int width, int height, const Color& fill)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

  int width() const { return width_; }
  int height() const { return height_; }

  /// Mixes a colour into one pixel.
  void blend(int x, int y, const Color& color, float alpha) {
    Color& pixel = pixels_[index(x, y)];
    pixel += alpha * (color - pixel);
  }
  const Color& at(int x, int y) const { return pixels_[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }

  int width_, height_;
  std::vector<Color> pixels_;
};

}  // namespace quadrille
