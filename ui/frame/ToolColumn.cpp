// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/ToolColumn.h"

#include "ui/base/Theme.h"

#include <QAction>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

/// Of the buttons, and what lies between them.
struct Sizes {
    int height;
    int spacing;
};
constexpr Sizes namedSizes{.height = 48, .spacing = 3};
constexpr Sizes iconSizes{.height = 25, .spacing = 2}; // at least: all tools go into 700 pixels
constexpr int greatestIconHeight = 40; // where there is room, as large as a pen hits well

} // namespace

ToolColumn::ToolColumn(QWidget* parent)
    : QFrame(parent)
    , m_layout(new QVBoxLayout(this))
{
    setProperty("role", QStringLiteral("panel"));
    setObjectName(QStringLiteral("toolColumn"));
    m_layout->setContentsMargins(1, theme::smallPadding, 1, theme::smallPadding);
    m_layout->setSpacing(namedSizes.spacing);
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
    button->setFixedSize(56, namedSizes.height);
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

int ToolColumn::heightWith(int buttonHeight, int spacing) const
{
    const int others = m_layout->count() - 1 - int(m_buttons.size()); // lines, without the stretch
    const QMargins margins = m_layout->contentsMargins();
    return int(m_buttons.size()) * buttonHeight + others + (m_layout->count() - 1) * spacing
        + margins.top() + margins.bottom();
}

QSize ToolColumn::minimumSizeHint() const
{
    return {58, heightWith(iconSizes.height, iconSizes.spacing)};
}

void ToolColumn::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    const bool named = height() >= heightWith(namedSizes.height, namedSizes.spacing);
    Sizes sizes = named ? namedSizes : iconSizes;
    if (!named && !m_buttons.empty()) {
        const int room = (height() - heightWith(0, sizes.spacing)) / int(m_buttons.size());
        sizes.height = std::clamp(room, iconSizes.height, greatestIconHeight);
    }
    m_layout->setSpacing(sizes.spacing);
    for (QToolButton* button : m_buttons) {
        button->setToolButtonStyle(named ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonIconOnly);
        button->setFixedHeight(sizes.height);
    }
}

} // namespace ui
