// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/morphology/planes/PlaneSketch.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace core {

// Shape-based interpolation between drawn planes of any directions, exactly and in whole numbers.
// Divisions round down, ⌊√…⌋ too.
//
// 1. Shapes. What was drawn on a plane are the pixels of it under which the label is
//    (voxelUnder()). A part (pixels that touch at sides or corners) of which every pixel also lies
//    on another plane is left out. Each pixel has a signed distance to the border, greater than 0
//    inside (SketchedShape::at() blends them between pixels). No distance counts for less than
//    -`reach`, the longest side of a part on any plane, at least eight pixels; beyond the pixels it
//    is -reach.
// 2. Hidden planes. A voxel sees a plane at its foot, the nearest place there, at the height h (at
//    least 1 unit). Planes are looked at from the nearest on, of equally near ones from the first
//    on. One that was looked at before and is not hidden hides others if the distance at the
//    voxel's foot on it is greater than -reach: those of which the foot is on its other side. So a
//    drawing does not reach past another one. A voxel that lies on a plane (isOn()), with such a
//    distance at its foot, was drawn there and does not change.
// 3. Pairs. Two planes that are not hidden enclose the voxel
//    - if they are parallel or nearly so and it lies between them. The distances s_i and s_j are
//      those at its feet.
//    - if they meet in a line, and something was drawn on both sides of the wedge in which the
//      voxel lies, at least a pixel's width from the line. The voxel is turned about that line into
//      either plane; s_i and s_j are the distances there. So contours around an axis make a round
//      body, and those across a bent tube make a bent tube.
//    Both distances have to be greater than -reach, so that things that lie apart stay apart. Then
//    f = (s_i·h_j + s_j·h_i) / (h_i + h_j): s_i on plane i and s_j on plane j.
// 4. The label gets a free voxel if there is a pair, and if Σ w·f ≥ 0 over all pairs, with
//    w = n_i·n_j·(1 + 15·facing), where n_i = max(1, 256·(h of the nearest) / h_i) and facing is
//    ((1 - cos) / 2)⁴ with the angle between the normals that point to the voxel: 1 for two planes
//    that face each other (Between::facing()).

/// The free voxels (label 0) that the label receives. Work is divided among threads by slices. Cost
/// ∝ the pixels of the planes, and the voxels of the box in which something may be filled. Any
/// thread outside a parallelFor(). Errors: OutOfMemory, Cancelled.
/// @param labels one for each voxel of the volume, x fastest
/// @pre the sketch belongs to a volume of this size
[[nodiscard]] Result<VoxelRuns> voxelsBetweenPlanes(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, const PlaneSketch& sketch,
    const Progress& progress);

/// For each plane, whether what a user drew there shows where the label ends on it, rather than
/// being touched up in few places: at least a fifth of the label's pixels on it are on no other
/// plane. Any thread outside a parallelFor().
[[nodiscard]] std::vector<bool> drawnAsWhole(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, const PlaneSketch& sketch);

} // namespace core
