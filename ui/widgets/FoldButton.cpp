// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/FoldButton.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"

#include <QScrollArea>
#include <QTimer>

namespace ui {

FoldButton::FoldButton(QWidget& body, QWidget* parent)
    : QToolButton(parent)
    , m_body(body)
{
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setIconSize(QSize(14, 14));
    setAutoRaise(true);
    setFont(theme::smallFont());
    setStyleSheet(QStringLiteral("padding: 2px 4px 2px 0"));
    connect(this, &QToolButton::clicked, this, [this] {
        setFolded(!folded());
        if (!folded())
            QTimer::singleShot(0, this, &FoldButton::bringIntoView); // when it is laid out
    });
    setFolded(true);
}

void FoldButton::bringIntoView()
{
    for (QWidget* widget = parentWidget(); widget; widget = widget->parentWidget()) {
        auto* area = qobject_cast<QScrollArea*>(widget);
        if (!area)
            continue;
        area->ensureWidgetVisible(&m_body, 0, theme::padding);
        area->ensureWidgetVisible(this, 0, theme::padding); // of what is too high the head
    }
}

bool FoldButton::folded() const
{
    return m_body.isHidden();
}

void FoldButton::setFolded(bool folded)
{
    m_body.setVisible(!folded);
    setIcon(stateIcon(folded ? QStringLiteral("chevron-right") : QStringLiteral("chevron-down")));
}

} // namespace ui
