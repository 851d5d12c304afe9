// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SegmentOpacity.h"

#include "ui/menus/SliderRow.h"
#include "ui/workspace/Workspace.h"

namespace ui {

void addSegmentOpacity(QMenu& menu, Workspace& workspace, int label)
{
    addSliderRow(menu,
        {.id = "segmentOpacity",
            .text = QObject::tr("Opacity"),
            .accessibleName = QObject::tr("Opacity of the segment"),
            .tip = QObject::tr("How opaque the segment is in slices and in the 3D view"),
            .least = Workspace::leastSegmentOpacity,
            .now = workspace.segmentOpacity(label),
            .changed = [&workspace, label](
                           int percent) { workspace.setSegmentOpacity(label, percent); }});
}

} // namespace ui
