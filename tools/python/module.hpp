#pragma once

#include <pybind11/pybind11.h>

namespace quadrille::python {

/// Bind the shapes, what detection finds, the detector, hands and grasps, and the planner to the
/// module, in this order.
void bind_shapes(pybind11::module_& module);
void bind_findings(pybind11::module_& module);
void bind_detector(pybind11::module_& module);
void bind_grasps(pybind11::module_& module);
void bind_planner(pybind11::module_& module);

}  // namespace quadrille::python
