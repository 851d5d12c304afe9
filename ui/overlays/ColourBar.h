// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/ColourMap.h"

#include <QRect>
#include <QString>

class QPainter;

namespace ui {

/// The legend of a slice in colours: the colours of the values from the lower end of the window
/// (below) to its upper end (above).
struct ColourBar {
    gpu::ColourMap map = gpu::ColourMap::Grey;
    bool inverted = false;
    QString upper; ///< texts at its two ends
    QString lower;
};

/// Returns its place in a view: a narrow bar at the right edge, below the orientation letter. Empty
/// if the view is too low for it.
[[nodiscard]] QRect colourBarPlace(const QRect& view);

void paintColourBar(QPainter& painter, const QRect& view, const ColourBar& bar);

} // namespace ui
