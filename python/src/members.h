// SPDX-License-Identifier: GPL-3.0-or-later
// Members of the library's structs as attributes: vectors as read-only arrays over the same memory.
#pragma once

#include "arrays.h"

namespace rimline::python {

template <auto member>
struct Member;

template <class Whole, class Vector, Vector Whole::*member>
struct Member<member> {
  // Given to def_prop_ro().
  static auto view(const Whole& whole) { return view_of(whole.*member, nb::find(whole)); }
};

}  // namespace rimline::python
