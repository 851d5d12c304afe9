// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/FoldButton.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/widgets/BringIntoView.h"

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
            QTimer::singleShot(
                0, this, [this] { bringIntoView(m_body, *this); }); // laid out by then
    });
    setFolded(true);
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
