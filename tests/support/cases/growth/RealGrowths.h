// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/growth/SketchInterval.h"
#include "core/volume/Volume.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace test {

enum class RealStructure { Ventricles, Aorta, Liver, Tooth };

/// A structure of a shared study, with the edits by which a user segments it.
struct RealGrowth {
    core::LoadedVolume study;
    std::vector<std::uint8_t> reference; ///< 1 in the structure's voxels, x fastest
    std::vector<core::Edit> edits; ///< segment 1 becomes the structure
    std::vector<glm::ivec3> seeds; ///< voxels of the strokes in `edits`
};

/// The structure with its edits; none if there are no shared data.
///
/// Ventricles: the lateral ventricles of mr_brain_mricrop_itksnap, label "vent-lat", drawn by hand.
/// Aorta: the crop of ct_totalseg_body_3mm, label aorta, by a network; it is dissected and stented,
/// so its values range from those of muscle to those of metal. Liver: the whole of that study,
/// label liver, by a network. Tooth: a molar of ct_cranium_inv3, for which there is no mask; its
/// outline was drawn by eye, voxel by voxel on magnified slices, before anything was grown.
[[nodiscard]] std::optional<RealGrowth> realGrowth(RealStructure structure);

/// A structure as a user sketches it first, before anything has grown.
struct RealSketch {
    core::LoadedVolume study;
    std::vector<std::uint8_t> reference; ///< 1 in the structure's voxels, x fastest
    core::SeedSketch sketch;
};

enum class SketchedStructure { Ventricles, Aorta, Liver, Tooth, Bone, Lung };

/// None if there are no shared data.
///
/// The first four are those of RealGrowth: a stroke in each ventricle, along the aorta, across the
/// liver, down the crown. Bone: the skull of ct_cranium_inv3, sketched on the forehead as the 3D
/// view shows it from the front; reference: the bone that another program marked by 226 … 3071 HU.
/// Lung: label lung_lower_lobe_right of ct_totalseg_body_3mm, a stroke across it.
[[nodiscard]] std::optional<RealSketch> realSketch(SketchedStructure structure);

/// The voxels of a stroke on a slice that goes straight from corner to corner, each voxel once.
[[nodiscard]] std::vector<glm::ivec3> strokeVoxels(const std::vector<glm::ivec3>& corners);
[[nodiscard]] std::vector<glm::dvec3> placesOf(
    const core::VolumeGeometry& geometry, const std::vector<glm::ivec3>& voxels);

/// The number of user actions for an edit: a stroke, a button, a click; for a growth also its
/// interval, every criterion that is set, and every side of its box that was moved from the
/// volume's border.
[[nodiscard]] int userActions(const core::Edit& edit, const core::VolumeGeometry& geometry);

/// 2 |A ∩ B| / (|A| + |B|) of the voxels that are not 0.
[[nodiscard]] double dice(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b);
/// 1 where the label map has this label.
[[nodiscard]] std::vector<std::uint8_t> maskOf(
    const std::vector<std::uint8_t>& labels, std::uint8_t label);

} // namespace test
