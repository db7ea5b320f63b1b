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

}  // namespace quadrille::bus
