#include "picture/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

namespace quadrille {
namespace {

constexpr const char* kFont = "sans-serif";

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int size) {
  const auto* first = reinterpret_cast<const std::byte*>(data);
  auto& all = *static_cast<std::vector<std::byte>*>(bytes);
  try {
    all.insert(all.end(), first, first + size);
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* make_surface(Canvas::Format format, int width, int height,
                              std::vector<std::byte>* bytes) {
  switch (format) {
    case Canvas::Format::kPng:
      return cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    case Canvas::Format::kSvg:
      return cairo_svg_surface_create_for_stream(append, bytes, width, height);
    case Canvas::Format::kPdf:
      return cairo_pdf_surface_create_for_stream(append, bytes, width, height);
  }
  throw std::invalid_argument("format: not one of a picture");
}

void choose_font(cairo_t* context, double size) {
  cairo_select_font_face(context, kFont, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size);
}

/// A context on a page of one pixel, on which texts are measured and tried.
class Trial {
 public:
  explicit Trial(double size)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1)),
        context_(cairo_create(surface_)) {
    choose_font(context_, size);
  }
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  ~Trial() {
    cairo_destroy(context_);
    cairo_surface_destroy(surface_);
  }

  double measure(const std::string& text) {
    cairo_text_extents_t extents{};
    cairo_text_extents(context_, text.c_str(), &extents);
    return extents.x_advance;
  }
  bool is_text(const std::string& text) {
    measure(text);
    return cairo_status(context_) == CAIRO_STATUS_SUCCESS;
  }

 private:
  cairo_surface_t* surface_;
  cairo_t* context_;
};

/// Makes a text printable by Cairo.
std::string printable(std::string text) {
  const bool is_text = Trial(10.0).is_text(text);
  for (char& letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x20 || byte == 0x7f || (byte >= 0x80 && !is_text)) letter = '?';
  }
  return text;
}

/// Encodes a surface as a PNG file, with fast compression: in Cairo's own writer, zlib took a third
/// of the time of a picture.
std::vector<std::byte> pack_png(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(cairo_image_surface_get_width(surface));
  header.height = static_cast<png_uint_32>(cairo_image_surface_get_height(surface));
  header.format = PNG_FORMAT_RGB;
  header.flags = PNG_IMAGE_FLAG_FAST;
  std::vector<std::uint8_t> rgb;
  rgb.reserve(PNG_IMAGE_SIZE(header));
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (png_uint_32 y = 0; y < header.height; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(data + std::ptrdiff_t{stride} * y);
    for (png_uint_32 x = 0; x < header.width; ++x) {
      for (const int shift : {16, 8, 0}) rgb.push_back(static_cast<std::uint8_t>(row[x] >> shift));
    }
  }
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<std::byte> bytes(size);
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error(fmt::format("the picture cannot be packed ({})", header.message));
  }
  bytes.resize(size);
  return bytes;
}

std::uint8_t byte_of(float share) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0f, 1.0f) * 255.0f));
}

}  // namespace

Canvas::Canvas(Format format, int width, int height)
    : format_(format),
      surface_(make_surface(format, width, height, &bytes_)),
      context_(cairo_create(surface_.get())) {
  if (format == Format::kPdf) {
    // A fixed date makes the same picture give the same bytes each time.
    cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                   "2000-01-01T00:00:00Z");
  }
  cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
}

void Canvas::set_color(const Color& color, float alpha) {
  cairo_set_source_rgba(context_.get(), color.x(), color.y(), color.z(), alpha);
}

/// Makes a rectangle with rounded corners the current path.
void Canvas::trace(const Eigen::AlignedBox2d& box, double corner) {
  const double quarter = std::numbers::pi / 2;
  cairo_t* c = context_.get();
  const Eigen::Vector2d low = box.min().array() + corner, high = box.max().array() - corner;
  cairo_new_path(c);
  cairo_arc(c, high.x(), low.y(), corner, -quarter, 0.0);
  cairo_arc(c, high.x(), high.y(), corner, 0.0, quarter);
  cairo_arc(c, low.x(), high.y(), corner, quarter, 2 * quarter);
  cairo_arc(c, low.x(), low.y(), corner, 2 * quarter, 3 * quarter);
  cairo_close_path(c);
}

void Canvas::fill(const Eigen::AlignedBox2d& box, const Color& color, float alpha, double corner) {
  set_color(color, alpha);
  trace(box, corner);
  cairo_fill(context_.get());
}

void Canvas::outline(const Eigen::AlignedBox2d& box, const Color& color, double width,
                     double corner) {
  set_color(color, 1.0f);
  trace(box, corner);
  cairo_set_line_width(context_.get(), width);
  cairo_stroke(context_.get());
}

void Canvas::draw(const Image& image, const Eigen::AlignedBox2d& box) {
  const std::unique_ptr<cairo_surface_t, Destroy> pixels(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width(), image.height()));
  unsigned char* data = cairo_image_surface_get_data(pixels.get());
  const int stride = cairo_image_surface_get_stride(pixels.get());
  for (int y = 0; y < image.height(); ++y) {
    auto* row = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < image.width(); ++x) {
      const Color& color = image.at(x, y);
      row[x] = std::uint32_t{byte_of(color.x())} << 16 | std::uint32_t{byte_of(color.y())} << 8 |
               byte_of(color.z());
    }
  }
  cairo_surface_mark_dirty(pixels.get());
  cairo_t* c = context_.get();
  cairo_save(c);
  cairo_translate(c, box.min().x(), box.min().y());
  cairo_scale(c, box.sizes().x() / image.width(), box.sizes().y() / image.height());
  cairo_set_source_surface(c, pixels.get(), 0.0, 0.0);
  // Without padding, the border pixels of a scaled image would be mixed with nothing. Vector
  // formats scale only when they are shown, and Cairo 1.18 turns a padded pattern into an image of
  // many times as many pixels.
  if (format_ == Format::kPng) cairo_pattern_set_extend(cairo_get_source(c), CAIRO_EXTEND_PAD);
  cairo_pattern_set_filter(cairo_get_source(c), CAIRO_FILTER_BILINEAR);
  cairo_rectangle(c, 0.0, 0.0, image.width(), image.height());
  cairo_fill(c);
  cairo_restore(c);
}

void Canvas::draw(const Strokes& strokes) {
  cairo_t* c = context_.get();
  cairo_new_path(c);
  for (const Segment& s : strokes.segments) {
    if (!s.from.allFinite() || !s.to.allFinite()) continue;
    cairo_move_to(c, s.from.x(), s.from.y());
    cairo_line_to(c, s.to.x(), s.to.y());
  }
  set_color(strokes.color, strokes.alpha);
  cairo_set_line_width(c, strokes.width);
  cairo_stroke(c);
}

void Canvas::draw(const Disc& disc) {
  if (!disc.center.allFinite()) return;
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), disc.center.x(), disc.center.y(), disc.radius, 0.0,
            2 * std::numbers::pi);
  set_color(disc.color, 1.0f);
  cairo_fill(context_.get());
}

void Canvas::write(const std::string& text, const Eigen::Vector2d& at, double size,
                   const Color& color) {
  choose_font(context_.get(), size);
  set_color(color, 1.0f);
  cairo_move_to(context_.get(), at.x(), at.y());
  cairo_show_text(context_.get(), printable(text).c_str());
}

void Canvas::clip(const Eigen::AlignedBox2d& box) {
  trace(box, 0.0);
  cairo_clip(context_.get());
}

void Canvas::clip_nothing() { cairo_reset_clip(context_.get()); }

double Canvas::measure(const std::string& text, double size) {
  return Trial(size).measure(printable(text));
}

std::vector<std::byte> Canvas::finish() {
  cairo_show_page(context_.get());
  cairo_status_t status = cairo_status(context_.get());
  if (status == CAIRO_STATUS_SUCCESS && format_ == Format::kPng) {
    bytes_ = pack_png(surface_.get());
  }
  cairo_surface_finish(surface_.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface_.get());
  // A surface that was finished properly reports this as an error.
  if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_SURFACE_FINISHED) {
    throw std::runtime_error(
        fmt::format("the picture cannot be drawn ({})", cairo_status_to_string(status)));
  }
  return std::move(bytes_);
}

}  // namespace quadrille
