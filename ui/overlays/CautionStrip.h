// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QRect>
#include <QString>

class QPainter;

namespace ui {

/// What is wrong with the geometry, all of it, in one line.
[[nodiscard]] QString cautionText(const core::Volume& volume);

/// The bar across a view whose volume must not be measured without thought: one line below the
/// upper corner texts, so that it hides neither letters nor middle. The bar above the views and the
/// series doctor say the rest.
void paintCautionStrip(QPainter& painter, const QRect& view, const core::Volume& volume);

} // namespace ui
