// SPDX-License-Identifier: Apache-2.0
#include "ui/base/RevisionText.h"

#include <QCoreApplication>

namespace ui {

QString keepsPlaceText(std::size_t strokes)
{
    return strokes == 1
        ? QCoreApplication::translate("ui::StrokeRevision",
            "One later stroke began on the surface that this changed; it keeps its place.")
        : QCoreApplication::translate("ui::StrokeRevision",
            "%1 later strokes began on the surface that this changed; they keep their place.")
              .arg(strokes);
}

} // namespace ui
