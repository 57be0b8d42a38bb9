// SPDX-License-Identifier: GPL-3.0-or-later
// Options as keyword arguments: names, defaults and ranges are those of visit_fields and nothing else.
#include "rimline/options.h"

#include <fmt/format.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "arrays.h"
#include "call.h"
#include "names.h"
#include "parts.h"

namespace rimline::python {
namespace {

using Triple = std::array<double, 3>;

template <class T>
nb::object as_python(const T& value) {
  if constexpr (std::is_enum_v<T>) {
    return nb::cast(std::string(name(value)));
  } else {
    return nb::cast(value);
  }
}

// Of a field, 0 by its word where it has one.
template <class T>
nb::object value_in_python(const Field<T>& field) {
  if (field.zero[0] != 0 && field.value == std::remove_const_t<T>{}) return nb::cast(std::string(field.zero));
  return as_python(field.value);
}

template <class T>
const char* type_name() {
  if constexpr (std::is_enum_v<T>) return "choice";
  if constexpr (std::same_as<T, bool>) return "bool";
  return std::integral<T> ? "int" : "float";
}

template <class T>
[[noreturn]] void refuse_type(const Field<T>& field, nb::handle value) {
  const std::string wanted = std::is_enum_v<T>       ? "a name"
                             : std::same_as<T, bool> ? "True or False"
                             : std::integral<T>      ? "an integer"
                                                     : "a number";
  throw nb::type_error(
      fmt::format("{} must be {}, not {}", field.name, wanted, nb::cast<std::string>(nb::repr(value)))
          .c_str());
}

template <class T>
[[noreturn]] void refuse_range(const Field<T>& field, nb::handle value) {
  throw Error(ErrorCode::BadOption,
              fmt::format("{} is {}; it must lie between {} and {}", field.name,
                          nb::cast<std::string>(nb::str(value)), field.least, field.most));
}

// An integer of Python or NumPy, as it says by __index__.
template <class T>
void set_integer(const Field<T>& field, nb::handle value) {
  const nb::object whole = nb::steal(PyNumber_Index(value.ptr()));
  if (!whole.is_valid()) {
    PyErr_Clear();
    refuse_type(field, value);
  }
  std::int64_t number = 0;
  if (!nb::try_cast(whole, number) || number < field.least || number > field.most) refuse_range(field, value);
  field.value = static_cast<T>(number);
}

// check_options looks at the range of numbers; what can not be held in a field is refused here.
template <class T>
void set_field(const Field<T>& field, nb::handle value) {
  const bool is_switch = PyBool_Check(value.ptr()) != 0;
  if constexpr (std::is_enum_v<T>) {
    std::string text;
    if (!nb::try_cast(value, text)) refuse_type(field, value);
    field.value = value_of<T>(field.name, text);
  } else if constexpr (std::same_as<T, bool>) {
    if (!is_switch) refuse_type(field, value);
    field.value = value.is(Py_True);
  } else if constexpr (std::integral<T>) {
    if (is_switch) refuse_type(field, value);
    std::string text;
    if (field.zero[0] != 0 && nb::try_cast(value, text) && text == field.zero) {
      field.value = T{};
    } else {
      set_integer(field, value);
    }
  } else {
    double number = 0;
    if (is_switch || !nb::try_cast(value, number)) refuse_type(field, value);
    field.value = number;
  }
}

Options options_of(const std::string& preset, const Dict& given) {
  Options options = preset_options(value_of<Preset>("preset", preset));
  nb::dict left = nb::borrow<nb::dict>(given.attr("copy")());
  visit_fields(options, [&left](const auto& field) {
    if (!left.contains(field.name)) return;
    set_field(field, left[field.name]);
    nb::del(left[field.name]);
  });
  if (left.contains("holes")) options.mesh.holes = parse_holes(nb::cast<std::string>(left["holes"]));
  if (left.contains("up")) {
    const auto [x, y, z] = nb::cast<Triple>(left["up"]);
    options.mesh.up = {x, y, z};
  }
  if (left.contains("corners")) options.map.corners = nb::cast<std::array<Index, 4>>(left["corners"]);
  check_options(options);
  return options;
}

Dict defaults_of(Preset preset) {
  Dict values;
  const Options options = preset_options(preset);
  visit_fields(options, [&](const auto& field) { values[field.name] = value_in_python(field); });
  return values;
}

template <class Struct>
bool holds(const Struct& options, const void* field) {
  const auto* begin = reinterpret_cast<const std::byte*>(&options);
  const auto* place = static_cast<const std::byte*>(field);
  return place >= begin && place < begin + sizeof(Struct);
}

// The member of Options that holds a field.
const char* group_of(const Options& options, const void* field) {
  if (holds(options.boundary, field)) return "boundary";
  if (holds(options.loops, field)) return "loops";
  if (holds(options.boundary_loops, field)) return "boundary_loops";
  return holds(options.map, field) ? "map" : "mesh";
}

// One dictionary a field: name, group, type, default, least and most or choices, help.
Items fields() {
  Items all;
  const Options options = preset_options(Preset::Default);
  visit_fields(options, [&]<class T>(const Field<T>& field) {
    using Value = std::remove_const_t<T>;
    Dict one;
    one["name"] = field.name;
    one["group"] = group_of(options, &field.value);
    one["type"] = type_name<Value>();
    one["default"] = value_in_python(field);
    if (field.zero[0] != 0) one["word"] = field.zero;
    one["help"] = field.help;
    if constexpr (std::is_enum_v<Value>) {
      one["choices"] = nb::cast(names_of<Value>());
    } else if constexpr (!std::same_as<Value, bool>) {
      one["least"] = field.least;
      one["most"] = field.most;
    }
    all.append(one);
  });
  return all;
}

Dict presets() {
  Dict all;
  for (const std::string& preset : names_of<Preset>()) {
    all[preset.c_str()] = defaults_of(value_of<Preset>("preset", preset));
  }
  return all;
}

}  // namespace

void add_options(nb::module_& m) {
  nb::class_<Options>(m, "Options");
  m.def("options", &options_of, nb::arg("preset"), nb::arg("given"));
  m.def("fields", &fields);
  m.def("presets", &presets);
  nb::class_<RunArguments>(m, "Run").def(
      "__init__",
      [](RunArguments* self, std::uint64_t seed, int threads, std::size_t memory_limit, nb::object progress) {
        new (self) RunArguments{seed, threads, memory_limit, std::move(progress)};
      },
      nb::arg("seed"), nb::arg("threads"), nb::arg("memory_limit"), nb::arg("progress").none());
}

}  // namespace rimline::python
