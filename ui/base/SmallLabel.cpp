// SPDX-License-Identifier: Apache-2.0
#include "ui/base/SmallLabel.h"

#include "ui/base/Theme.h"

#include <QLabel>

namespace ui {

QLabel* smallText(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setFont(theme::smallFont());
    label->setWordWrap(true);
    return label;
}

QLabel* smallNote(const QString& text, QWidget* parent, Qt::Alignment side)
{
    auto* label = new QLabel(text, parent);
    label->setFont(theme::smallFont());
    label->setProperty("role", QStringLiteral("secondary"));
    label->setAlignment(side | Qt::AlignVCenter);
    return label;
}

} // namespace ui
