#include "python/octomap.hpp"

#include <octomap/OcTree.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/planner/octree_file.hpp"
#include "quadrille/grasping/occupancy.hpp"

namespace quadrille::python {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

PyMap map_of(const py::bytes& content, const std::string& name) {
  const auto text = static_cast<std::string_view>(content);
  return {io::parse_octree(std::as_bytes(std::span(text.data(), text.size())), name)};
}

/// @param name  of the points in errors
void set_voxels(const Rows& points, const std::string& name, float log_odds,
                octomap::OcTree* tree) {
  for (Eigen::Index n = 0; n < points.rows(); ++n) {
    const octomap::point3d p(static_cast<float>(points(n, 0)), static_cast<float>(points(n, 1)),
                             static_cast<float>(points(n, 2)));
    octomap::OcTreeKey key;
    if (!points.row(n).allFinite() || !tree->coordToKeyChecked(p, key)) {
      throw std::invalid_argument(name + "[" + std::to_string(n) +
                                  "] does not lie within 32768 voxels of the map's origin");
    }
    tree->setNodeValue(key, log_odds, true);
  }
}

PyMap map_from_voxels(const Rows& occupied, const Rows& free, double resolution) {
  if (!(resolution >= 1e-6 && resolution <= 1e3)) {
    throw std::invalid_argument("resolution must be the edge of a voxel, from 1e-6 to 1000 m");
  }
  const auto tree = std::make_shared<octomap::OcTree>(resolution);
  set_voxels(free, "free", tree->getClampingThresMinLog(), tree.get());
  set_voxels(occupied, "occupied", tree->getClampingThresMaxLog(), tree.get());
  tree->updateInnerOccupancy();
  tree->prune();
  return {tree};
}

/// The states of all voxels, of shape (x, y, z).
py::array_t<std::uint8_t> states_of(const OccupancyGrid& grid) {
  const Eigen::Vector3i& size = grid.size();
  const std::vector<py::ssize_t> shape = {size.x(), size.y(), size.z()};
  const std::vector<py::ssize_t> strides = {1, size.x(), py::ssize_t{size.x()} * size.y()};
  static_assert(sizeof(Voxel) == 1);
  return {shape, strides, reinterpret_cast<const std::uint8_t*>(grid.states().data())};
}

}  // namespace

void bind_maps(py::module_& module) {
  py::class_<PyMap>(module, "OctoMap",
                    "A map of a scene, read from an OctoMap's file or made of points.")
      .def(py::init(&map_of), py::arg("content"), py::arg("name") = "octomap")
      .def_static("from_voxels", &map_from_voxels, py::arg("occupied"), py::arg("free"),
                  py::arg("resolution"),
                  "A map of the voxels in which these points, (N, 3) [m], lie, occupied or free, "
                  "with edges of resolution [m]. What is both is occupied.")
      .def_property_readonly(
          "content", [](const PyMap& map) { return py::bytes(io::octree_bytes(*map.tree)); },
          "The content of a .bt file.")
      .def_property_readonly(
          "resolution", [](const PyMap& map) { return map.tree->getResolution(); },
          "Edge of a voxel [m].");
  py::class_<OccupancyGrid, std::shared_ptr<OccupancyGrid>>(
      module, "Space", "Free, occupied and unknown space in a box of voxels.")
      .def_property_readonly("states", &states_of,
                             "Of each voxel along x, y, z: 0 unknown, 1 clear (not seen, but above "
                             "free space), 2 free, 3 occupied; uint8.")
      .def_property_readonly(
          "corner",
          [](const OccupancyGrid& grid) -> Eigen::Vector3d {
            return grid.corner().cast<double>() * grid.resolution();
          },
          "Least corner of the first voxel in frame C, (3,) [m].")
      .def_property_readonly(
          "resolution", [](const OccupancyGrid& grid) { return grid.resolution(); },
          "Edge of a voxel [m].")
      .def(
          "octomap", [](const OccupancyGrid& grid) { return PyMap{grid.to_octree()}; },
          "The same as an OctoMap, in which clear space is unknown.");
}

}  // namespace quadrille::python
