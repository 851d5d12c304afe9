// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/encoding/EarlySlice.h"
#include "gpu/scene/Scene.h"

#include <QImage>

namespace ui {

/// What the engine will draw of a scene, as far as one slice tells it (gpu/render/slice.frag): for
/// the time until all slices are there. Null where the scene's plane is not that slice.
[[nodiscard]] QImage earlyPicture(
    const core::EarlySlice& early, const gpu::SliceScene& scene, const QSize& pixels);

/// Whether a scene's plane is that slice, wherever it crosses the volume.
[[nodiscard]] bool showsEarlySlice(const core::EarlySlice& early, const gpu::SliceScene& scene);

} // namespace ui
