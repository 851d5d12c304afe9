// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/ColourMap.h"

#include <QRect>
#include <QString>

class QPainter;

namespace ui {

/// The legend of a slice in colours: which colour is which value, from the lower end of the window
/// to its upper end.
struct ColourBar {
    gpu::ColourMap map = gpu::ColourMap::Grey;
    bool inverted = false;
    QString upper; ///< what stands at its ends
    QString lower;
};

/// Where it lies in a view: narrow, at the right, below the orientation letter. Empty where the
/// view is too low for it.
[[nodiscard]] QRect colourBarPlace(const QRect& view);

void paintColourBar(QPainter& painter, const QRect& view, const ColourBar& bar);

} // namespace ui
