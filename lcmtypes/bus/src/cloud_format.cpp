#include "quadrille/bus/cloud_message.hpp"

namespace quadrille::bus {

std::string_view to_string(CloudFormat format) {
  switch (format) {
    case CloudFormat::kDrake:
      return "drake";
    case CloudFormat::kPointCloud2:
      return "pointcloud2";
    case CloudFormat::kPointCloud:
      return "pointcloud";
  }
  return "drake";
}

std::optional<CloudFormat> cloud_format_from_string(std::string_view name) {
  for (const CloudFormat format : all_cloud_formats()) {
    if (name == to_string(format)) return format;
  }
  return std::nullopt;
}

}  // namespace quadrille::bus
