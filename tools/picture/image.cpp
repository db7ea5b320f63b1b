#include "picture/image.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille {

Image::Image(int width, int height, const Color& fill)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

void Image::blend(int x, int y, const Color& color, float alpha) {
  if (!holds(x, y)) return;
  Color& pixel = pixels_[index(x, y)];
  pixel += alpha * (color - pixel);
}

std::vector<std::uint8_t> Image::bytes() const {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * pixels_.size());
  for (const Color& pixel : pixels_) {
    for (int i = 0; i < 3; ++i) {
      bytes.push_back(static_cast<std::uint8_t>(std::clamp(pixel[i], 0.0f, 1.0f) * 255.0f + 0.5f));
    }
  }
  return bytes;
}

void draw_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
               const Color& color, float alpha, Image* image) {
  if (!from.allFinite() || !to.allFinite()) return;
  const double pad = width / 2 + 1;
  const Eigen::Vector2d low = from.cwiseMin(to).array() - pad,
                        high = from.cwiseMax(to).array() + pad;
  const Eigen::Vector2d along = to - from;
  const double square = std::max(along.squaredNorm(), 1e-12);
  const int left = static_cast<int>(std::clamp(low.x(), 0.0, image->width() - 1.0));
  const int right = static_cast<int>(std::clamp(high.x(), 0.0, image->width() - 1.0));
  const int top = static_cast<int>(std::clamp(low.y(), 0.0, image->height() - 1.0));
  const int bottom = static_cast<int>(std::clamp(high.y(), 0.0, image->height() - 1.0));
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const Eigen::Vector2d p(x, y);
      const double share = std::clamp((p - from).dot(along) / square, 0.0, 1.0);
      const double cover = width / 2 + 0.5 - (from + share * along - p).norm();
      if (cover > 0) image->blend(x, y, color, alpha * static_cast<float>(std::min(cover, 1.0)));
    }
  }
}

void draw_disc(const Eigen::Vector2d& center, double radius, const Color& color, Image* image) {
  draw_line(center, center, 2 * radius, color, 1.0f, image);
}

void draw_rectangle(int left, int top, int width, int height, const Color& color, float alpha,
                    Image* image) {
  for (int y = top; y < top + height; ++y) {
    for (int x = left; x < left + width; ++x) image->blend(x, y, color, alpha);
  }
}

}  // namespace quadrille
