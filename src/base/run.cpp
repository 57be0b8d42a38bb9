// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/run.h"

namespace rimline {

const char* name(Stage stage) {
  switch (stage) {
    case Stage::Read: return "read";
    case Stage::Arrange: return "arrange";
    case Stage::Neighbours: return "neighbours";
    case Stage::Boundary: return "boundary";
    case Stage::Survey: return "survey";
    case Stage::Loops: return "loops";
    case Stage::Parameterize: return "parameterize";
    case Stage::Triangulate: return "triangulate";
    case Stage::Refine: return "refine";
    case Stage::Measure: return "measure";
    case Stage::Write: return "write";
  }
  return "?";
}

void Run::check_cancel() const {
  if (cancelled()) throw Error(ErrorCode::Cancelled, "interrupted");
}

int exit_status(ErrorCode code) {
  switch (code) {
    case ErrorCode::BadOption: return 1;
    case ErrorCode::CannotRead: return 2;
    case ErrorCode::TooFewPoints:
    case ErrorCode::NoClosedLoop:
    case ErrorCode::UnreachableInterior:
    case ErrorCode::NotADisc:
    case ErrorCode::NoConvergence: return 3;
    case ErrorCode::OutOfMemory:
    case ErrorCode::CannotWrite: return 4;
    case ErrorCode::Cancelled: return 5;
  }
  return 3;
}

}  // namespace rimline
