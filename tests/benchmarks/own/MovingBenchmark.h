// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace bench {

class PeerReport;

/// frame.moving.*: a picture of 1230 × 870 pixels while the camera goes around, from the request to
/// the listener. frame.settled.*: from letting go to the refined picture. As surface, by volume
/// rendering and as MIP; of the demonstration head and, where the shared data are, of a real CT
/// (frame.moving.real.*). Each last moving picture is compared with the refined one first.
/// @return why the pictures are not right; empty: all is added
QString measureMoving(PeerReport& report);

} // namespace bench
