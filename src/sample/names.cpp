// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/sample.h"

namespace rimline {

const char* name(Shape shape) {
  switch (shape) {
    case Shape::FlatDisc: return "flat-disc";
    case Shape::BumpySquare: return "bumpy-square";
    case Shape::WavySaddle: return "wavy-saddle";
    case Shape::HemisphereCap: return "hemisphere-cap";
    case Shape::SphereMinusCap: return "sphere-minus-cap";
    case Shape::HalfTunnel: return "half-tunnel";
    case Shape::CurledStrip: return "curled-strip";
    case Shape::Pipe: return "pipe";
    case Shape::SquareWithHoles: return "square-with-holes";
    case Shape::CappedTube: return "capped-tube";
    case Shape::ClosedSphere: return "closed-sphere";
    case Shape::TorusMinusCap: return "torus-minus-cap";
    case Shape::MoebiusStrip: return "moebius-strip";
  }
  return "?";
}

const char* name(Sampling sampling) {
  switch (sampling) {
    case Sampling::BlueNoise: return "blue-noise";
    case Sampling::Random: return "random";
    case Sampling::Grid: return "grid";
    case Sampling::SmoothDensity: return "smooth-density";
    case Sampling::DensityStep: return "density-step";
    case Sampling::ScanLines: return "scan-lines";
    case Sampling::Cropped: return "cropped";
  }
  return "?";
}

const std::vector<Shape>& all_shapes() {
  static const std::vector<Shape> shapes = {
      Shape::FlatDisc,        Shape::BumpySquare, Shape::WavySaddle,   Shape::HemisphereCap,
      Shape::SphereMinusCap,  Shape::HalfTunnel,  Shape::CurledStrip,  Shape::Pipe,
      Shape::SquareWithHoles, Shape::CappedTube,  Shape::ClosedSphere, Shape::TorusMinusCap,
      Shape::MoebiusStrip};
  return shapes;
}

const std::vector<Sampling>& all_samplings() {
  static const std::vector<Sampling> samplings = {
      Sampling::BlueNoise,   Sampling::Random,    Sampling::Grid,   Sampling::SmoothDensity,
      Sampling::DensityStep, Sampling::ScanLines, Sampling::Cropped};
  return samplings;
}

}  // namespace rimline
