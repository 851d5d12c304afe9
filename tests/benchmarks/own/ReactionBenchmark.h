// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace bench {

class PeerReport;

/// From a step of the hand to the pictures that show it, of a 3D view of 1230 × 870 pixels and
/// three slices of 400 × 400. frame.moving.drill, frame.moving.grow: to the 3D view's moving
/// picture, from one report of the pen, or some generations. history.drill.undo.picture and
/// redo.picture: to its first picture. refine.chunks.click.picture: to those of all views. What is
/// told in pieces is compared with the whole first, voxels and pictures.
/// @return why the results are not equal; empty: all is added
QString measureReactions(PeerReport& report);

} // namespace bench
