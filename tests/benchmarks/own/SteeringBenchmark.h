// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace bench {

class PeerReport;

/// What steering a growth costs in 512 cubed, with 10 million voxels grown: steer.generation (of a
/// front of 9801 voxels, against the same in 128 cubed), steer.opening (a drag of the interval
/// begins), steer.slider (the interval is moved by two voxels' worth, either way), steer.recovery
/// (what was suspended comes back, as another burst), steer.scrub (to a generation five off, and to
/// any), steer.sketch (600 pixels), steer.slider.picture (from an event of the slider to the first
/// moving picture of 1230 × 870 pixels), and the bytes of seed words for a thousand voxels that
/// were grown.
/// @return why the results are not right; empty: all is added
QString measureSteering(PeerReport& report);

} // namespace bench
