// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

struct PenSample;

/// The grids on which numbers that decide voxels lie (DESIGN §3.2). Numbers are rounded once, where
/// the recipe or the pen enters; recipe, session and replay then hold the same form, to the bit.
namespace quantum {

constexpr double perMillimetre = 1024.0; ///< positions, radii, depths: multiples of 1/1024 mm
constexpr double perDirection = 1048576.0; ///< components of a direction: multiples of 2⁻²⁰
constexpr double perPressure = 65535.0; ///< pressure: multiples of 1/65535
constexpr double perDegree = 1024.0; ///< turns of pieces
constexpr double perZoom = 1024.0; ///< of pieces
constexpr double perSecond = 10000.0; ///< time: multiples of 0.1 ms
// Modality values (bounds, thresholds) are not rounded: they become integer codes by an exact
// search (VoxelEncoding), and JSON holds every double exactly.

constexpr double reachMm = 100000.0; ///< no position lies farther out
constexpr double unbounded = 1e300; ///< the range of modality values

} // namespace quantum

/// The edit with every number on its grid. quantised(quantised(e)) equals quantised(e), and
/// editFromJson(editToJson(quantised(e))) equals quantised(e), to the bit.
[[nodiscard]] Edit quantised(const Edit& edit);

/// The same for one piece of a pen path.
[[nodiscard]] std::vector<PenSample> quantised(const std::vector<PenSample>& samples);
/// … or of a brush's path.
[[nodiscard]] std::vector<glm::dvec3> quantised(const std::vector<glm::dvec3>& pointsLps);

} // namespace core
