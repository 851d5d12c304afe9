// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/volume/Volume.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace test {

enum class RealStructure { Ventricles, Aorta, Liver, Tooth };

/// A structure of a shared study, as a user takes it out with growth.
struct RealGrowth {
    core::LoadedVolume study;
    std::vector<std::uint8_t> reference; ///< 1 in the structure's voxels, x fastest
    std::vector<core::Edit> edits; ///< segment 1 becomes the structure
    std::vector<glm::ivec3> seeds; ///< voxels of the strokes in `edits`
};

/// None where there are no shared data.
///
/// Ventricles: the lateral ones of mr_brain_mricrop_itksnap, label "vent-lat", drawn by hand.
/// Aorta: the crop of ct_totalseg_body_3mm, label aorta, of a network; dissected and stented, so
/// that its values run from those of muscle to those of metal. Liver: the whole of that study,
/// label liver, of a network. Tooth: a molar of ct_cranium_inv3, for which there is no mask; its
/// outline was drawn by eye, voxel by voxel on magnified slices, before anything was grown.
[[nodiscard]] std::optional<RealGrowth> realGrowth(RealStructure structure);

/// A stroke on a slice: straight from corner to corner, each voxel once.
[[nodiscard]] std::vector<glm::ivec3> strokeVoxels(const std::vector<glm::ivec3>& corners);
[[nodiscard]] std::vector<glm::dvec3> placesOf(
    const core::VolumeGeometry& geometry, const std::vector<glm::ivec3>& voxels);

/// What the user does for an edit: a stroke, a button, a click; of a growth also its interval,
/// every criterion that is set, and every side of its box that is moved from the volume's end.
[[nodiscard]] int userActions(const core::Edit& edit, const core::VolumeGeometry& geometry);

/// 2 |A ∩ B| / (|A| + |B|) of the voxels that are not 0.
[[nodiscard]] double dice(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b);
/// 1 where a map of labels holds this one.
[[nodiscard]] std::vector<std::uint8_t> maskOf(
    const std::vector<std::uint8_t>& labels, std::uint8_t label);

} // namespace test
