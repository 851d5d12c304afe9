// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/questions/VoxelQuestions.h"
#include "ui/geometry/ViewContext.h"
#include "ui/workspace/Workspace.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace ui {

/// The voxel that is seen along each ray; none if nothing is seen.
using PickedVoxels = std::vector<std::optional<glm::ivec3>>;

/// The camera of a 3D view in the form that edits store.
[[nodiscard]] core::OrthographicView orthographicView(const gpu::VolumeScene& scene);

/// The question to the engine which voxels the user sees at these points of the 3D view, one ray
/// per point. The render mode decides whether that is the surface, the opacity or the brightest
/// voxel.
/// @param planeMm points in the view plane, mm right of and above the target
[[nodiscard]] core::PickQuestion pickQuestion(const gpu::VolumeScene& scene,
    const std::vector<glm::dvec2>& planeMm, const core::Volume& volume);

/// The opacity of a transfer function by code >> 8, in 1/65535 per sample of @p sampleMm.
[[nodiscard]] std::vector<std::uint32_t> opacityOfCodes(
    const gpu::TransferFunction& function, const core::VoxelEncoding& encoding, double sampleMm);

/// Points along a polyline, including its ends, never further apart than @p step.
[[nodiscard]] std::vector<glm::dvec2> alongPath(const std::vector<glm::dvec2>& path, double step);

} // namespace ui
