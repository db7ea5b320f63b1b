#include "python/module.hpp"

#include "io/file_bytes.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "What quadrille has in C++; import quadrille instead.";
  module.attr("__version__") = QUADRILLE_VERSION;
  pybind11::register_exception<quadrille::io::FileError>(module, "FileError", PyExc_ValueError);
  quadrille::python::bind_shapes(module);
  quadrille::python::bind_findings(module);
  quadrille::python::bind_detector(module);
  quadrille::python::bind_grasps(module);
  quadrille::python::bind_planner(module);
}
