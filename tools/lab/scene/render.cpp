#include "lab/scene/render.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::scene {
namespace {

/// Pixels that a surface may cover: first and last column and row.
struct Window {
  int left = 0, right = -1, top = 0, bottom = -1;
};

Window window_of(const Camera& camera, const Eigen::AlignedBox3d& box_S,
                 const Eigen::Isometry3d& X_CS) {
  Eigen::AlignedBox2d pixels;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p =
        X_CS * box_S.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
    // A surface that reaches behind the camera may cover any part of the image.
    if (p.z() < 0.05) return {0, camera.width - 1, 0, camera.height - 1};
    pixels.extend(Eigen::Vector2d(camera.focal * p.x() / p.z() + camera.cx,
                                  camera.focal * p.y() / p.z() + camera.cy));
  }
  const auto clip = [](double v, int last) {
    return static_cast<int>(std::clamp(v, -1.0, last + 1.0));
  };
  return {std::max(0, clip(std::floor(pixels.min().x()), camera.width)),
          std::min(camera.width - 1, clip(std::ceil(pixels.max().x()), camera.width)),
          std::max(0, clip(std::floor(pixels.min().y()), camera.height)),
          std::min(camera.height - 1, clip(std::ceil(pixels.max().y()), camera.height))};
}

/// Depth and surface indices of one body alone.
struct Layer {
  std::vector<double> depth;
  std::vector<int> surface;
};

void cast(const Camera& camera, const SurfaceCaster& caster, const Window& window, int index,
          Layer* layer) {
  for (int row = window.top; row <= window.bottom; ++row) {
    for (int column = window.left; column <= window.right; ++column) {
      const auto t = caster.first_hit(camera.ray(column, row));
      const std::size_t pixel = static_cast<std::size_t>(row) * camera.width + column;
      if (!t || (layer->surface[pixel] >= 0 && layer->depth[pixel] <= *t)) continue;
      layer->depth[pixel] = *t;
      layer->surface[pixel] = index;
    }
  }
}

void merge(const Layer& layer, Rendering* out) {
  for (std::size_t i = 0; i < layer.depth.size(); ++i) {
    if (layer.surface[i] < 0) continue;
    ++out->alone[layer.surface[i]];
    if (out->surface[i] >= 0 && out->depth[i] <= layer.depth[i]) continue;
    out->depth[i] = layer.depth[i];
    out->surface[i] = layer.surface[i];
  }
}

}  // namespace

Rendering render(const Camera& camera, const std::vector<Body>& bodies,
                 const Eigen::Isometry3d& X_CW) {
  const std::size_t pixels = static_cast<std::size_t>(camera.width) * camera.height;
  Rendering out;
  out.depth.assign(pixels, 0.0);
  out.surface.assign(pixels, -1);
  out.normal.assign(pixels, Eigen::Vector3f::Zero());
  std::vector<SurfaceCaster> casters;
  for (const Body& body : bodies) {
    Layer layer{std::vector<double>(pixels, 0.0), std::vector<int>(pixels, -1)};
    for (std::size_t i = 0; i < body.surfaces.size(); ++i) {
      const Eigen::Isometry3d X_CS = X_CW * body.X_WB * body.X_BS[i];
      casters.emplace_back(body.surfaces[i], X_CS);
      cast(camera, casters.back(), window_of(camera, body.surfaces[i].box_S, X_CS),
           static_cast<int>(casters.size()) - 1, &layer);
    }
    out.alone.resize(casters.size(), 0);
    merge(layer, &out);
  }
  out.visible.assign(casters.size(), 0);
  for (std::size_t i = 0; i < pixels; ++i) {
    if (out.surface[i] < 0) continue;
    ++out.visible[out.surface[i]];
    const int column = static_cast<int>(i % camera.width), row = static_cast<int>(i / camera.width);
    const Eigen::Vector3d p_C = out.depth[i] * camera.ray(column, row);
    out.normal[i] = casters[out.surface[i]].normal(p_C).cast<float>();
  }
  return out;
}

}  // namespace quadrille::scene
