#include "python/Bindings.hpp"

#include "io/Failure.hpp"
#include "io/InputError.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>

namespace naocal {

namespace py = pybind11;

namespace {

/// Raises the exception with this sentence; bytes that are not UTF-8, as in names of files, are escaped.
void raise(PyObject* type, const std::string& sentence) {
  const auto text = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(sentence.data(), static_cast<Py_ssize_t>(sentence.size()), "backslashreplace"));
  PyErr_SetObject(type, text.ptr());
}

PyObject* inputError = nullptr; // lives as long as the interpreter

/// Raises naocal.InputError for what the terminal's program ends with exit code 2. Others are left to pybind11.
void translate(std::exception_ptr error) {
  try {
    std::rethrow_exception(std::move(error));
  } catch (const InputError& wrong) {
    raise(inputError, wrong.what());
  } catch (const std::filesystem::filesystem_error& refused) {
    raise(inputError, describeFailure(refused).sentence);
  } catch (const std::domain_error& beyond) {
    raise(inputError, describeFailure(beyond).sentence);
  }
}

} // namespace

void bindErrors(py::module_& module) {
  inputError = PyErr_NewExceptionWithDoc("naocal.InputError",
                                         "Wrong input, such as a file or a label: one sentence says where, what was "
                                         "expected, what was found and what to do.",
                                         PyExc_ValueError, nullptr);
  module.attr("InputError") = py::handle{inputError};
  py::register_exception_translator(translate);
}

} // namespace naocal

PYBIND11_MODULE(_naocal, module) {
  module.attr("__version__") = NAOCAL_VERSION;
  naocal::bindErrors(module);
  naocal::bindCaptures(module);
  naocal::bindSimulation(module);
  naocal::bindResult(module);
  naocal::bindComparison(module);
  naocal::bindDiagnosis(module);
}
