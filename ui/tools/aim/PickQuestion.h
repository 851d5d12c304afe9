// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/questions/VoxelQuestions.h"
#include "ui/geometry/ViewContext.h"
#include "ui/workspace/Workspace.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace ui {

/// The voxel that was seen along each ray; none: nothing was.
using PickedVoxels = std::vector<std::optional<glm::ivec3>>;

/// The camera of a 3D view, as edits name it.
[[nodiscard]] core::OrthographicView orthographicView(const gpu::VolumeScene& scene);

/// "What does the user see at these points of the 3D view?", one ray per point. Surface, opacity or
/// brightest voxel after the mode the view draws in.
/// @param planeMm points in the view plane, mm right of and above the target
[[nodiscard]] core::PickQuestion pickQuestion(const gpu::VolumeScene& scene,
    const std::vector<glm::dvec2>& planeMm, const core::Volume& volume);

/// Opacity of a transfer function by code >> 8, in 65535ths per sample of @p sampleMm.
[[nodiscard]] std::vector<std::uint32_t> opacityOfCodes(
    const gpu::TransferFunction& function, const core::VoxelEncoding& encoding, double sampleMm);

/// Points along a polyline, its ends included, never further apart than @p step.
[[nodiscard]] std::vector<glm::dvec2> alongPath(const std::vector<glm::dvec2>& path, double step);

} // namespace ui
