// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "core/sculpt/labels/EditableVoxels.h"
#include "core/sculpt/labels/LabelOutlined.h"
#include "core/sculpt/labels/LabelScissors.h"
#include "core/sculpt/labels/LabelThreshold.h"
#include "core/sculpt/labels/LayerWrites.h"
#include "tests/reference/fields/DenseFields.h"

namespace reference {

// What passes between layers and segments (core/sculpt/labels/LayerWrites.h), voxel by voxel.

/// core/sculpt/labels/EditableVoxels.h. Of no such rule: every voxel is.
[[nodiscard]] bool isEditable(const std::optional<core::EditableVoxels>& editable,
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const glm::ivec3& voxel);

void labelCarved(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::LabelCarved& edit);
/// @param carved coverage of the layers that are not muted, composed
void labelSeen(const DenseArray<std::uint16_t>& codes, const DenseArray<std::uint8_t>& carved,
    DenseFields& fields, const core::LabelSeen& edit);
void labelListed(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::LabelListed& edit);
void labelPlanes(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::LabelPlanes& edit);
void relabelListed(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::RelabelListed& edit);
/// core/sculpt/labels/LabelOutlined.h.
void labelOutlined(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::LabelOutlined& edit);
/// core/sculpt/labels/LabelScissors.h; in a source of its own.
void labelScissors(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::LabelScissors& edit);
/// core/sculpt/labels/LabelThreshold.h.
/// @param carved as above
void labelThreshold(const DenseArray<std::uint16_t>& codes, const DenseArray<std::uint8_t>& carved,
    DenseFields& fields, const core::LabelThreshold& edit);
void mapLabels(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::MapLabels& edit);
void mapPlanes(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::MapPlanes& edit);
/// Of growth (core/growth/GrowthCommands.h), listed in the same way.
void writeBarriers(DenseFields& fields, const core::BarrierListed& edit);
void coverLabel(DenseFields& fields, const core::CoverLabel& edit);
void foldLayer(DenseFields& fields, const core::FoldLayer& edit);

} // namespace reference
