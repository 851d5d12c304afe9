// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/ItkMask.h"
#include "tests/peers/cases/PeerMask.h"

namespace peer {

/// What lies between drawn slices across z, by ITK's exact distances: within each drawn slice every
/// voxel has that to the nearest one on the other side of its border, and between two of them these
/// are blended. Debian has none of ITK's remote modules, among them its morphological contour
/// interpolation.
///
/// That is Burin's rule, too, where a slice has one part that overlaps the one in the other. Where
/// they have several, or these do not overlap, Burin matches parts, and either may be right.
/// @param apart how far the drawn slices lie apart, from the first of the volume on
[[nodiscard]] PeerMask blendedSlices(const GridMask& mask, int apart);

} // namespace peer
