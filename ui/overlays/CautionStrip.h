// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QRect>
#include <QString>

class QPainter;

namespace ui {

/// All problems of the volume's geometry, in one line.
[[nodiscard]] QString cautionText(const core::Volume& volume);

/// Draws a strip across a view whose volume must not be measured without caution: one line below
/// the upper corner texts, so that it covers neither letters nor the middle. The bar above the
/// views and the series doctor give the details.
void paintCautionStrip(QPainter& painter, const QRect& view, const core::Volume& volume);

} // namespace ui
