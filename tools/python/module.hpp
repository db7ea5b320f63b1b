#pragma once

#include <pybind11/pybind11.h>

namespace quadrille::python {

/// Bind the shapes, the parts of the detector, and those of the planner, to the module.
void bind_shapes(pybind11::module_& module);
void bind_detector(pybind11::module_& module);
void bind_planner(pybind11::module_& module);

}  // namespace quadrille::python
