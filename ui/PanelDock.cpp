// SPDX-License-Identifier: Apache-2.0
#include "ui/PanelDock.h"

#include "ui/Icons.h"
#include "ui/Theme.h"
#include "ui/panels/Panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>

namespace ui {

namespace {

constexpr int panelWidth = 330;

/// As high as its panel would like to be; always as wide as the others, or the pictures would
/// change their size whenever a panel's words do.
class PanelScroll : public QScrollArea {
public:
    using QScrollArea::QScrollArea;
    [[nodiscard]] QSize sizeHint() const override
    {
        return {panelWidth, widget() ? widget()->sizeHint().height() : 0};
    }
};

} // namespace

PanelDock::PanelDock(Panel& panel, QWidget* parent)
    : QDockWidget(panel.title(), parent)
    , m_panel(panel)
    , m_body(new PanelScroll(this))
    , m_fold(new QToolButton(this))
{
    setObjectName(panel.title() + QStringLiteral("Dock"));
    setFeatures(DockWidgetMovable | DockWidgetFloatable | DockWidgetClosable);
    setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);

    auto* header = new QFrame(this);
    header->setProperty("role", QStringLiteral("bar"));
    auto* row = new QHBoxLayout(header);
    // A dock asks its title for the size it would like, not for the one it is fixed to.
    row->setContentsMargins(4, 3, 6, 3);
    row->setSpacing(2);
    m_fold->setIconSize(QSize(14, 14));
    m_fold->setFixedSize(22, 24);
    m_fold->setToolTip(QStringLiteral("Fold or unfold"));
    row->addWidget(m_fold);
    auto* title = new QLabel(panel.title(), header);
    title->setFont(theme::headingFont());
    row->addWidget(title);
    row->addStretch(1);
    auto* summary = new QLabel(panel.summary(), header);
    summary->setFont(theme::smallFont());
    summary->setProperty("role", QStringLiteral("secondary"));
    summary->setContentsMargins(0, 0, 4, 0);
    row->addWidget(summary);
    for (QAction* action : panel.actions()) {
        auto* button = new QToolButton(header);
        button->setDefaultAction(action);
        button->setIconSize(QSize(16, 16));
        button->setFixedSize(24, 22);
        row->addWidget(button);
    }
    setTitleBarWidget(header);

    // A low window scrolls inside its panels; they never make it higher.
    m_body->setWidget(&panel);
    m_body->setWidgetResizable(true);
    m_body->setMinimumWidth(panelWidth);
    m_body->setFrameShape(QFrame::NoFrame);
    m_body->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_body->viewport()->setObjectName(QStringLiteral("panelBody"));
    m_body->viewport()->setStyleSheet(
        QStringLiteral("#panelBody { background: %1; }").arg(theme::panel.name()));
    setWidget(m_body);

    connect(&panel, &Panel::summaryChanged, summary, &QLabel::setText);
    connect(m_fold, &QToolButton::clicked, this, [this] { setFolded(!m_folded); });
    setFolded(false);
}

void PanelDock::setFolded(bool folded)
{
    m_folded = folded;
    m_fold->setIcon(
        stateIcon(folded ? QStringLiteral("chevron-right") : QStringLiteral("chevron-down")));
    m_body->setMinimumHeight(folded ? 0 : m_panel.stretches() ? 64 : 40);
    // What does not stretch takes no more than it needs.
    const int most = m_panel.stretches() ? QWIDGETSIZE_MAX : m_panel.sizeHint().height();
    m_body->setMaximumHeight(folded ? 0 : most);
}

} // namespace ui
