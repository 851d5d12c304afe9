// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace bench {

class PeerReport;

/// mask.lasso: 2000 points at 1230 × 870, against Qt's rasterizer (no edge filter).
/// sculpt.*: what one report of the pen costs until a picture can show it: cut, radiation,
/// macro-cells; on cubes of 128, 256 and 512 voxels with the same surface in the middle, and
/// against radiation and macro-cells of the whole volume worked out anew.
/// frame.*: pictures of the demonstration head before and after its skull is opened, and with four
/// pieces of it laid aside.
/// @return what is not right; then nothing is added
QString measureSculpting(PeerReport& report);

} // namespace bench
