// SPDX-License-Identifier: GPL-3.0-or-later
// rimline::Error becomes the package's rimline.Error, with its code and ids.
#include <nanobind/stl/string.h>

#include <string>

#include "arrays.h"
#include "parts.h"
#include "rimline/run.h"

namespace rimline::python {
namespace {

void raise(const Error& error) {
  const nb::object type = nb::module_::import_("rimline._errors").attr("Error");
  const nb::object made =
      type(std::string(error.what()), error.code(), give(std::vector<Index>(error.ids())));
  PyErr_SetObject(type.ptr(), made.ptr());
}

void translate(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    try {
      raise(error);
    } catch (nb::python_error& failed) {
      failed.restore();
    }
  }
}

}  // namespace

void add_errors(nb::module_& m) {
  nb::enum_<ErrorCode>(m, "ErrorCode")
      .value("BadOption", ErrorCode::BadOption)
      .value("CannotRead", ErrorCode::CannotRead)
      .value("TooFewPoints", ErrorCode::TooFewPoints)
      .value("NoClosedLoop", ErrorCode::NoClosedLoop)
      .value("UnreachableInterior", ErrorCode::UnreachableInterior)
      .value("NotADisc", ErrorCode::NotADisc)
      .value("NoConvergence", ErrorCode::NoConvergence)
      .value("OutOfMemory", ErrorCode::OutOfMemory)
      .value("CannotWrite", ErrorCode::CannotWrite)
      .value("Cancelled", ErrorCode::Cancelled);
  m.def("exit_status", &exit_status, nb::arg("code"));
  nb::register_exception_translator(translate);
}

}  // namespace rimline::python
