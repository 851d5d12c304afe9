// SPDX-License-Identifier: Apache-2.0
#include "ui/ToolColumn.h"

#include "ui/Theme.h"

#include <QAction>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

ToolColumn::ToolColumn(QWidget* parent)
    : QFrame(parent)
    , m_layout(new QVBoxLayout(this))
{
    setProperty("role", QStringLiteral("panel"));
    setObjectName(QStringLiteral("toolColumn"));
    m_layout->setContentsMargins(1, theme::smallPadding, 1, theme::smallPadding);
    m_layout->setSpacing(4);
    m_layout->addStretch(1);
    setFixedWidth(58);
}

void ToolColumn::addTool(QAction& action, const QString& label)
{
    auto* button = new QToolButton(this);
    button->setDefaultAction(&action);
    button->setText(label);
    // The action renames itself with its state; under the icon stands the short name.
    connect(&action, &QAction::changed, button, [button, label] { button->setText(label); });
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(QSize(theme::iconSize, theme::iconSize));
    button->setFont(theme::smallFont());
    button->setStyleSheet(QStringLiteral("padding: 3px 0"));
    button->setFixedSize(56, 48);
    button->setFocusPolicy(Qt::NoFocus);
    const QString keys = action.shortcut().toString(QKeySequence::NativeText);
    button->setToolTip(
        keys.isEmpty() ? action.text() : action.text() + QStringLiteral("  ") + keys);
    m_layout->insertWidget(m_layout->count() - 1, button, 0, Qt::AlignHCenter);
}

void ToolColumn::addGroupLine()
{
    auto* line = new QFrame(this);
    line->setFixedHeight(1);
    line->setStyleSheet(QStringLiteral("background: %1").arg(theme::line.name()));
    m_layout->insertWidget(m_layout->count() - 1, line);
}

} // namespace ui
