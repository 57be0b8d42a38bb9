// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvalues and eigenvectors of a symmetric 3x3 matrix, without iteration over rotations or trigonometry.
#pragma once

#include "base/lanes.h"
#include "rimline/points.h"

namespace rimline {

struct Covariance {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

struct PrincipalAxes {
  double lambda[3] = {0, 0, 0};  // ascending
  Point v[3];                    // orthonormal, in the order of lambda
};

// Finds the eigenvalue that is farthest from the other two as a root of the characteristic polynomial, its
// vector as a cross product, and the other two in the plane across. Errors are those of rounding, relative
// to the largest eigenvalue, whatever the eigenvalues. Only + - * / and square roots: the same on every
// machine.  [ours; the order of steps after Eberly, A Robust Eigensolver for 3x3 Symmetric Matrices, 2014]
PrincipalAxes principal_axes(const Covariance& m);

// The same of a matrix in each lane: the same bytes.
struct CovarianceLanes {
  Lanes xx, xy, xz, yy, yz, zz;
};
struct PrincipalAxesLanes {
  Lanes lambda[3];
  Lanes x[3], y[3], z[3];  // of v

  PrincipalAxes of(int l) const {
    return {{lambda[0][l], lambda[1][l], lambda[2][l]},
            {{x[0][l], y[0][l], z[0][l]}, {x[1][l], y[1][l], z[1][l]}, {x[2][l], y[2][l], z[2][l]}}};
  }
};
void principal_axes(const CovarianceLanes& m, PrincipalAxesLanes& axes);

}  // namespace rimline
