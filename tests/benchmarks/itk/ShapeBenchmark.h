// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace bench {

class PeerReport;

/// segment.large.*.picture: from asking for a margin, or for smoothing, of a segment of 512 × 512 ×
/// 400 voxels to the first picture of its preview in all views (Desk.h), of a liver of about 1.5 L
/// and of the whole body. What a preview shows in the end is compared with the step itself.
/// segment.large.*.margin: the whole of a margin, against ITK's distance map.
/// @return why the results are not equal; empty: all is added
QString measureShapes(PeerReport& report);

} // namespace bench
