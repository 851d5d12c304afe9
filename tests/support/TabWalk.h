// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

namespace test {

/// Where the tab key goes up again, or back within a row, in a shown dialog of one column: "A, then
/// B". Empty: nowhere.
[[nodiscard]] inline QString tabDisorder(QWidget& dialog)
{
    const auto named = [](const QWidget& widget) {
        const QString text = widget.property("text").toString();
        return QStringLiteral("%1 %2 %3")
            .arg(QLatin1String(widget.metaObject()->className()), widget.objectName(), text);
    };
    const QWidget* before = nullptr;
    for (QWidget* at = dialog.nextInFocusChain(); at != &dialog; at = at->nextInFocusChain()) {
        // What lies within another, as the line of a spin box does, is no stop of its own.
        if (!dialog.isAncestorOf(at) || !at->isVisible() || (at->focusPolicy() & Qt::TabFocus) == 0
            || (at->parentWidget()->focusPolicy() & Qt::TabFocus) != 0)
            continue;
        const QRect now(at->mapTo(&dialog, QPoint()), at->size());
        if (before) {
            const QRect last(before->mapTo(&dialog, QPoint()), before->size());
            const bool sameRow =
                now.top() <= last.center().y() && now.bottom() >= last.center().y();
            if (sameRow ? now.left() < last.left() : now.top() < last.top())
                return QStringLiteral("%1, then %2").arg(named(*before), named(*at));
        }
        before = at;
    }
    return {};
}

} // namespace test
