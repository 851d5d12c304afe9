// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/ToolColumn.h"

#include "ui/base/Theme.h"

#include <QAction>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int namedHeight = 48;
constexpr int iconHeight = 30;

} // namespace

ToolColumn::ToolColumn(QWidget* parent)
    : QFrame(parent)
    , m_layout(new QVBoxLayout(this))
{
    setProperty("role", QStringLiteral("panel"));
    setObjectName(QStringLiteral("toolColumn"));
    m_layout->setContentsMargins(1, theme::smallPadding, 1, theme::smallPadding);
    m_layout->setSpacing(3);
    m_layout->addStretch(1);
    // The buttons follow the column's height, not the other way round.
    m_layout->setSizeConstraint(QLayout::SetNoConstraint);
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
    button->setFixedSize(56, namedHeight);
    button->setFocusPolicy(Qt::NoFocus);
    const QString keys = action.shortcut().toString(QKeySequence::NativeText);
    button->setToolTip(
        keys.isEmpty() ? action.text() : action.text() + QStringLiteral("  ") + keys);
    m_layout->insertWidget(m_layout->count() - 1, button, 0, Qt::AlignHCenter);
    m_buttons.push_back(button);
}

void ToolColumn::addGroupLine()
{
    auto* line = new QFrame(this);
    line->setFixedHeight(1);
    line->setStyleSheet(QStringLiteral("background: %1").arg(theme::line.name()));
    m_layout->insertWidget(m_layout->count() - 1, line);
}

int ToolColumn::heightWith(int buttonHeight) const
{
    const int others = m_layout->count() - 1 - int(m_buttons.size()); // lines, without the stretch
    const QMargins margins = m_layout->contentsMargins();
    return int(m_buttons.size()) * buttonHeight + others
        + (m_layout->count() - 1) * m_layout->spacing() + margins.top() + margins.bottom();
}

QSize ToolColumn::minimumSizeHint() const
{
    return {58, heightWith(iconHeight)};
}

void ToolColumn::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    const bool named = height() >= heightWith(namedHeight);
    for (QToolButton* button : m_buttons) {
        button->setToolButtonStyle(named ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonIconOnly);
        button->setFixedHeight(named ? namedHeight : iconHeight);
    }
}

} // namespace ui
