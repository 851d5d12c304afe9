// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace bench {

class PeerReport;

/// segment.skull.opening and so on: every operation on a whole segment that ITK has filters for, on
/// real series, where the shared data are. As id.kept the whole step: labels read, worked out,
/// written and kept in the history. How many voxels were compared, and why some differ, goes to the
/// standard error. segment.skull.mask.volume and segment.skull.distance: the volume masked by the
/// segment, and how far its islands are apart (SegmentReadings.h).
/// @return why the results are not right; empty: all is added
QString measureSegments(PeerReport& report);

} // namespace bench
