#pragma once

#include <pybind11/pybind11.h>

namespace naocal {

/// Each adds its classes and functions to the extension module; the package `naocal/` wraps the functions.
void bindErrors(pybind11::module_& module);
void bindCaptures(pybind11::module_& module);
void bindSimulation(pybind11::module_& module);
void bindResult(pybind11::module_& module);
void bindComparison(pybind11::module_& module);
void bindDiagnosis(pybind11::module_& module);

} // namespace naocal
