#pragma once

#include <pybind11/pybind11.h>

namespace quadrille::python {

/// What the module has of the detector, and of the planner.
void bind_detector(pybind11::module_& module);
void bind_planner(pybind11::module_& module);

}  // namespace quadrille::python
