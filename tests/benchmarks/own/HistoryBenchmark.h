// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/common/PeerReport.h"

#include <QString>

namespace bench {

/// history.*: what a step of undo costs on 512 × 512 × 600 voxels: bytes in the session file; undo
/// and redo of a step that is still in memory, and (".file") of one that is not; how long a commit,
/// an undo or a redo holds up the thread of the window at most (".held"). Against a full copy of
/// both fields (labels and coverage) and against run-length coding, whole image and difference. And
/// the memory that ten thousand strokes take, on a small volume.
///
/// Adds its figures to @p report. Prints to stderr what it does.
/// @return why the results are not right, so that there are no figures; empty: there are
QString measureHistory(PeerReport& report);

} // namespace bench
