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
  for (const CloudFormat format :
       {CloudFormat::kDrake, CloudFormat::kPointCloud2, CloudFormat::kPointCloud}) {
    if (name == to_string(format)) return format;
  }
  return std::nullopt;
}

}  // namespace quadrille::bus
