// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QRect>
#include <QString>

class QPainter;

namespace ui {

/// What is wrong with the geometry, all of it, in one line.
[[nodiscard]] QString cautionText(const core::Volume& volume);

/// The bar across a view whose volume must not be measured without thought, below the upper corner
/// texts and as high as its words need.
void paintCautionStrip(QPainter& painter, const QRect& view, const core::Volume& volume);

} // namespace ui
