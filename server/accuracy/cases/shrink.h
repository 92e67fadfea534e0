// Makes a failing ray simpler while it still fails.
#pragma once
#include "server/accuracy/cases/exam.h"

namespace raywalk::accuracy {

/// Drops triangles, and takes bits off the ray and the vertices, as long as `still_fails` says so; equal vertices stay
/// equal. Unchanged where there is no such function or it does not fail with what it is given.
Failure shrunk(Failure failure);

}  // namespace raywalk::accuracy
