// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstddef>

namespace ui {

/// What is told of strokes that began on the surface of a cut that was revised
/// (core::EditSession::strokesOnRevisedSurface()).
[[nodiscard]] QString keepsPlaceText(std::size_t strokes);

} // namespace ui
