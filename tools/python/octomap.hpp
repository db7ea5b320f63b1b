#pragma once

#include <memory>

#include "python/arrays.hpp"

namespace octomap {
class OcTree;
}

namespace quadrille::python {

/// A map of a scene.
struct PyMap {
  std::shared_ptr<const octomap::OcTree> tree;
};

/// Binds maps of OctoMap, and the space of plans.
void bind_maps(py::module_& module);

}  // namespace quadrille::python
