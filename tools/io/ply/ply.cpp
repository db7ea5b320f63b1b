#include "io/ply/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "io/file_bytes.hpp"
#include "io/new_file.hpp"
#include "io/packed_point.hpp"
#include "io/ply/ply_body.hpp"
#include "io/ply/ply_header.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {
namespace {

using Columns = std::array<std::size_t, 3>;

bool is_float(const PlyProperty& property) {
  return !property.is_list && property.scalar >= PlyScalar::kFloat32;
}

/// Returns the positions of x, y and z among the vertex properties.
Columns position_columns(const PlyElement& vertex, const std::string& name) {
  Columns columns;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string wanted(1, "xyz"[axis]);
    const auto found =
        std::find_if(vertex.properties.begin(), vertex.properties.end(),
                     [&](const PlyProperty& property) { return property.name == wanted; });
    if (found == vertex.properties.end() || !is_float(*found)) {
      throw FileError(name, "property " + wanted,
                      "the vertices need it as float or double; export the cloud with positions");
    }
    columns[axis] = static_cast<std::size_t>(found - vertex.properties.begin());
  }
  return columns;
}

/// Returns the positions of red, green and blue, as a byte each; nullopt if the vertices have no
/// such colours.
std::optional<Columns> colour_columns(const PlyElement& vertex) {
  const std::array<std::string, 3> names = {"red", "green", "blue"};
  Columns columns;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto found =
        std::find_if(vertex.properties.begin(), vertex.properties.end(), [&](const auto& property) {
          return property.name == names[i] && !property.is_list &&
                 property.scalar == PlyScalar::kUint8;
        });
    if (found == vertex.properties.end()) return std::nullopt;
    columns[i] = static_cast<std::size_t>(found - vertex.properties.begin());
  }
  return columns;
}

bool can_read_in_place(const PlyHeader& header, const PlyElement& vertex, const Columns& columns) {
  const auto scalar = [&](int axis) { return vertex.properties[columns[axis]].scalar; };
  return header.format != PlyHeader::Format::kAscii && !vertex.has_list() &&
         scalar(0) == scalar(1) && scalar(1) == scalar(2);
}

PointLayout layout_in_place(const PlyHeader& header, const PlyElement& vertex,
                            const Columns& columns, const std::optional<Columns>& colours) {
  PointLayout layout;
  layout.big_endian = header.format == PlyHeader::Format::kBigEndian;
  if (vertex.properties[columns[0]].scalar == PlyScalar::kFloat64) {
    layout.scalar = PointLayout::Scalar::kFloat64;
  }
  const auto offset_of = [&](std::size_t column) {
    std::size_t offset = 0;
    for (std::size_t i = 0; i < column; ++i) offset += size_of(vertex.properties[i].scalar);
    return offset;
  };
  layout.x = offset_of(columns[0]);
  layout.y = offset_of(columns[1]);
  layout.z = offset_of(columns[2]);
  if (colours) {
    layout.rgb = {offset_of((*colours)[0]), offset_of((*colours)[1]), offset_of((*colours)[2])};
  }
  layout.point_step = vertex.min_bytes(false);
  return layout;
}

/// Sets the cloud's width and height: those of the comments if they fit the number of points,
/// otherwise one row.
void set_size(const PlyHeader& header, const PlyElement& vertex, PointLayout* layout) {
  constexpr std::uint64_t kMax = std::numeric_limits<int>::max();
  const bool sane = header.width > 1 && header.height > 1 && header.width <= kMax &&
                    header.height <= kMax && header.width * header.height == vertex.count;
  layout->width = sane ? header.width : vertex.count;
  layout->height = sane ? header.height : 1;
}

PointCloud read_vertices(std::span<const std::byte> bytes, const PlyHeader& header,
                         const PlyElement& vertex, PlyBody* body, const std::string& name,
                         const Eigen::Affine3d& X_CF) {
  const Columns columns = position_columns(vertex, name);
  const std::optional<Columns> colours = colour_columns(vertex);
  PointLayout layout;
  if (can_read_in_place(header, vertex, columns)) {
    body->check_count(vertex);
    layout = layout_in_place(header, vertex, columns, colours);
    set_size(header, vertex, &layout);
    return read_points(bytes.subspan(body->offset()), layout, X_CF);
  }
  const std::vector<PackedPoint> packed = body->read_points(vertex, columns, colours);
  layout = packed_points_layout(colours.has_value());
  set_size(header, vertex, &layout);
  return read_points(std::as_bytes(std::span(packed)), layout, X_CF);
}

}  // namespace

PointCloud parse_ply(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Affine3d& X_CF) {
  const PlyHeader header = parse_ply_header(bytes, name);
  PlyBody body(bytes, header, name);
  for (const PlyElement& element : header.elements) {
    if (element.name != "vertex") {
      body.skip(element);
      continue;
    }
    PointCloud cloud = read_vertices(bytes, header, element, &body, name, X_CF);
    cloud.viewpoint = X_CF * header.viewpoint;
    cloud.frame = header.frame;
    return cloud;
  }
  throw FileError(name, "header", "there is no 'vertex' element; export the cloud with points");
}

std::string ply_of(const PointCloud& cloud) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment units metres\n";
  text += fmt::format("comment viewpoint {} {} {}\n", cloud.viewpoint.x(), cloud.viewpoint.y(),
                      cloud.viewpoint.z());
  if (!cloud.frame.empty()) text += fmt::format("comment frame {}\n", cloud.frame);
  if (cloud.organised()) {
    text += fmt::format("comment width {} height {}\n", cloud.width, cloud.height);
  }
  text += fmt::format("element vertex {}\n", cloud.points.size());
  text += "property float x\nproperty float y\nproperty float z\n";
  const bool coloured = cloud.coloured();
  if (coloured) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  text += "end_header\n";
  text.reserve(text.size() + (coloured ? 15 : 12) * cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3f& p = cloud.points[i];
    for (const float value : {p.x(), p.y(), p.z()}) {
      const auto bits = std::bit_cast<std::uint32_t>(value);
      for (int shift = 0; shift < 32; shift += 8) {
        text.push_back(static_cast<char>((bits >> shift) & 0xff));
      }
    }
    if (!coloured) continue;
    for (const std::uint8_t value : cloud.colours[i]) text.push_back(static_cast<char>(value));
  }
  return text;
}

void write_ply(const std::string& path, const PointCloud& cloud) {
  write_file(path, ply_of(cloud));
}

}  // namespace quadrille::io
