// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstddef>

namespace ui {

/// The sentence for the user about strokes that began on the surface of a cut which was revised and
/// therefore keep their place (core::EditSession::strokesOnRevisedSurface()).
[[nodiscard]] QString keepsPlaceText(std::size_t strokes);

} // namespace ui
