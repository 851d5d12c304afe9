// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/encoding/EarlySlice.h"
#include "gpu/scene/Scene.h"

#include <QImage>

namespace ui {

/// The picture of a slice that is drawn without the engine (by the rules of gpu/render/slice.frag)
/// while the other slices of a study are still being loaded; linear where it would be cubic. Null
/// if the scene's plane is not that slice.
[[nodiscard]] QImage earlyPicture(
    const core::EarlySlice& early, const gpu::SliceScene& scene, const QSize& pixels);

/// Whether the plane of a scene is that slice.
[[nodiscard]] bool showsEarlySlice(const core::EarlySlice& early, const gpu::SliceScene& scene);

} // namespace ui
