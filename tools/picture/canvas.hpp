#pragma once

#include <cairo.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "picture/sketch.hpp"

namespace quadrille {

/// A page on which Cairo draws, and which becomes a PNG, SVG or PDF file.
class Canvas {
 public:
  enum class Format { kPng, kSvg, kPdf };

  /// @param width,  height  size in pixels, or in points for SVG and PDF
  Canvas(Format format, int width, int height);

  void fill(const Eigen::AlignedBox2d& box, const Color& color, float alpha, double corner = 0.0);
  void outline(const Eigen::AlignedBox2d& box, const Color& color, double width, double corner);
  /// Draws an image, scaled to the box.
  void draw(const Image& image, const Eigen::AlignedBox2d& box);
  void draw(const Strokes& strokes);
  void draw(const Disc& disc);
  /// Writes one line; bytes that are not valid UTF-8, and control characters, appear as '?'.
  /// @param at  start of the base line
  void write(const std::string& text, const Eigen::Vector2d& at, double size, const Color& color);
  /// Limits drawing to the box, until clip_nothing().
  void clip(const Eigen::AlignedBox2d& box);
  void clip_nothing();

  /// Returns the width of a text.
  static double measure(const std::string& text, double size);

  /// Returns the bytes of the file; nothing may be drawn afterwards.
  /// @throws std::runtime_error if Cairo failed
  std::vector<std::byte> finish();

 private:
  struct Destroy {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };
  void trace(const Eigen::AlignedBox2d& box, double corner);
  void set_color(const Color& color, float alpha);

  Format format_;
  std::vector<std::byte> bytes_;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

}  // namespace quadrille
