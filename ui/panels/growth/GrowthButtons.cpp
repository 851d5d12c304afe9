// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/GrowthButtons.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"

#include <QPushButton>

namespace ui {

QPushButton* transportButton(
    QWidget* parent, const QString& name, const QString& icon, const QString& text)
{
    auto* button = new QPushButton(stateIcon(icon), text, parent);
    button->setObjectName(name);
    button->setFixedHeight(theme::rowHeight);
    return button;
}

QPushButton* narrowButton(QWidget* parent, const QString& name, const QString& text)
{
    auto* button = new QPushButton(text, parent);
    button->setObjectName(name);
    button->setProperty("role", QStringLiteral("narrow"));
    button->setFixedHeight(theme::rowHeight);
    return button;
}

} // namespace ui
