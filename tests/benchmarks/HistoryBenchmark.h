// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/PeerReport.h"

#include <QString>

namespace bench {

/// history.*: what a step of undo costs on 512 × 512 × 600 voxels: bytes in the session file, undo
/// and redo, and how long a commit holds up the thread of the window; against a full copy of both
/// fields (labels and coverage) and against run-length coding, whole image and difference. And the
/// memory that ten thousand strokes take, on a small volume.
///
/// There is no paint tool yet: a seed stroke of 60 points stands for it.
///
/// Adds its figures to @p report. Prints to stderr what it does.
/// @return why the results are not right, so that there are no figures; empty: there are
QString measureHistory(PeerReport& report);

} // namespace bench
