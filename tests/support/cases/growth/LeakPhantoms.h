// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"
#include "tests/support/scenes/TestVolumes.h"

namespace test {

/// A phantom with a hole in its wall: a bent vessel, an organ of several balls, or a tree of
/// airways, connected by a neck to a large blob of the same values. It has partial volume at every
/// border, and noise.
struct LeakPhantom {
    const char* body = "";
    int neckRadius = 0; ///< voxels, 1 … 3; 0: there is no leak
    int neckLength = 0;
    Codes codes;
    glm::ivec3 seed{0}; ///< in the body
    int lowCode = 0; ///< admits the inside
    int highCode = 0;
    Bytes leak; ///< 1 in voxels of the blob
    std::int64_t leakVoxels = 0;
    glm::ivec3 click{0}; ///< a voxel in the blob
};

/// The phantom of a number: bodies, radii and lengths alternate with it; everything else is drawn
/// at random from it.
[[nodiscard]] LeakPhantom leakPhantom(int number, bool leaks);
/// The phantom as a volume: voxels of 1 mm, whose values are their codes.
[[nodiscard]] core::LoadedVolume loadedVolume(const LeakPhantom& phantom);

} // namespace test
