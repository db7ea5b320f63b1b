#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace quadrille {

/// Red, green and blue, 0 to 1.
using Color = Eigen::Vector3f;

/// An RGB image, row by row from the top.
class Image {
 public:
  Image(int width, int height, const Color& fill);

  int width() const { return width_; }
  int height() const { return height_; }
  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

  /// Mixes a colour into one pixel; outside of the image nothing happens.
  void blend(int x, int y, const Color& color, float alpha);
  const Color& at(int x, int y) const { return pixels_[index(x, y)]; }

  /// 3 bytes per pixel.
  std::vector<std::uint8_t> bytes() const;

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }

  int width_, height_;
  std::vector<Color> pixels_;
};

/// Draws a straight line with smooth edges.
/// @param from, to  in pixels
/// @param width     of the line [pixels]
void draw_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
               const Color& color, float alpha, Image* image);

/// Fills a disc with a smooth edge.
void draw_disc(const Eigen::Vector2d& center, double radius, const Color& color, Image* image);

/// Mixes a colour into a rectangle.
void draw_rectangle(int left, int top, int width, int height, const Color& color, float alpha,
                    Image* image);

}  // namespace quadrille
