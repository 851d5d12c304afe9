// SPDX-License-Identifier: Apache-2.0
#include "ui/PanelColumn.h"

#include "ui/Icons.h"
#include "ui/Theme.h"
#include "ui/panels/Panel.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int columnWidth = 332;
constexpr int headerHeight = 30;
constexpr int lowestList = 96;

} // namespace

PanelSection::PanelSection(Panel& panel, QWidget* parent)
    : QWidget(parent)
    , m_panel(panel)
    , m_header(new QFrame(this))
    , m_fold(new QToolButton(this))
{
    m_header->setProperty("role", QStringLiteral("bar"));
    m_header->setFixedHeight(headerHeight);
    m_header->installEventFilter(this);
    auto* row = new QHBoxLayout(m_header);
    row->setContentsMargins(4, 0, 6, 0);
    row->setSpacing(2);
    m_fold->setIconSize(QSize(14, 14));
    m_fold->setFixedSize(22, 22);
    m_fold->setToolTip(tr("Fold or unfold"));
    row->addWidget(m_fold);
    auto* title = new QLabel(panel.title(), m_header);
    title->setFont(theme::headingFont());
    row->addWidget(title);
    row->addStretch(1);
    auto* summary = new QLabel(panel.summary(), m_header);
    summary->setFont(theme::smallFont());
    summary->setProperty("role", QStringLiteral("secondary"));
    summary->setContentsMargins(0, 0, 4, 0);
    row->addWidget(summary);
    for (QAction* action : panel.actions()) {
        auto* button = new QToolButton(m_header);
        button->setDefaultAction(action);
        button->setIconSize(QSize(16, 16));
        button->setFixedSize(24, 22);
        row->addWidget(button);
    }

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_header);
    layout->addWidget(&panel, 1);
    if (!panel.stretches())
        setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);

    connect(&panel, &Panel::summaryChanged, summary, &QLabel::setText);
    connect(m_fold, &QToolButton::clicked, this, [this] { setFolded(!m_folded); });
    setFolded(false);
}

QSize PanelSection::sizeHint() const
{
    int height = headerHeight;
    if (!m_folded && m_panel.stretches())
        height += lowestList;
    else if (!m_folded)
        height += m_panel.hasHeightForWidth() ? m_panel.heightForWidth(columnWidth)
                                              : m_panel.sizeHint().height();
    return {columnWidth, height};
}

void PanelSection::setFolded(bool foldedNow)
{
    m_folded = foldedNow;
    m_panel.setVisible(!m_folded);
    updateGeometry();
    m_fold->setIcon(
        stateIcon(m_folded ? QStringLiteral("chevron-right") : QStringLiteral("chevron-down")));
    Q_EMIT folded(m_folded);
}

bool PanelSection::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_header && event->type() == QEvent::MouseButtonPress)
        setFolded(!m_folded);
    return QWidget::eventFilter(watched, event);
}

PanelColumn::PanelColumn(QWidget* parent)
    : QScrollArea(parent)
    , m_layout(nullptr)
{
    auto* content = new QFrame(this);
    content->setProperty("role", QStringLiteral("panel"));
    m_layout = new QVBoxLayout(content);
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(2);
    // What nothing stretches into, when all lists are folded.
    m_layout->addStretch(0);
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFixedWidth(columnWidth);
}

void PanelColumn::add(ui::Panel* panel)
{
    auto* section = new PanelSection(*panel, this);
    m_layout->insertWidget(m_layout->count() - 1, section, panel->stretches() ? 1 : 0);
    // A folded list leaves its share to the others.
    connect(section, &PanelSection::folded, this, [this, section, panel](bool folded) {
        m_layout->setStretchFactor(section, panel->stretches() && !folded ? 1 : 0);
    });
}

} // namespace ui
