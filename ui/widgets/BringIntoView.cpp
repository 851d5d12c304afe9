// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/BringIntoView.h"

#include "ui/base/Theme.h"

#include <QCoreApplication>
#include <QScrollArea>

namespace ui {

void bringIntoView(QWidget& part, QWidget& head)
{
    if (!part.isVisible())
        return;
    // Each layout around the part asks the next one for room by an event. Until all of them have
    // been asked, the part lies elsewhere.
    for (QWidget* widget = &part; widget; widget = widget->parentWidget())
        QCoreApplication::sendPostedEvents(widget, QEvent::LayoutRequest);
    for (QWidget* widget = part.parentWidget(); widget; widget = widget->parentWidget()) {
        auto* area = qobject_cast<QScrollArea*>(widget);
        if (!area)
            continue;
        area->ensureWidgetVisible(&part, 0, theme::padding);
        area->ensureWidgetVisible(&head, 0, theme::padding);
    }
}

} // namespace ui
