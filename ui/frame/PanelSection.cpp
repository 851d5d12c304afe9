// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/PanelSection.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/frame/Panel.h"
#include "ui/widgets/FittingLabel.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWindow>

#include <algorithm>

namespace ui {

namespace {

constexpr int headerHeight = 30;
constexpr int lowestList = 96;
constexpr int floatingList = 280;

} // namespace

PanelSection::PanelSection(Panel& panel, QWidget* parent)
    : QWidget(parent)
    , m_panel(panel)
    , m_header(new QFrame(this))
    , m_fold(new QToolButton(this))
    , m_place(new QToolButton(this))
{
    setWindowTitle(panel.title());
    setObjectName(id());
    buildHeader();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_header);
    layout->addWidget(&panel, 1);
    setFolded(panel.foldedAtFirst());
    showPlace();
    connect(&panel, &Panel::unfoldRequested, this, [this] { setFolded(false); });
}

void PanelSection::buildHeader()
{
    m_header->setProperty("role", QStringLiteral("bar"));
    m_header->setFixedHeight(headerHeight);
    m_header->setToolTip(tr("Click to fold, drag out to float"));
    m_header->installEventFilter(this);
    auto* row = new QHBoxLayout(m_header);
    row->setContentsMargins(4, 0, 6, 0);
    row->setSpacing(2);
    m_fold->setIconSize(QSize(14, 14));
    m_fold->setFixedSize(22, 22);
    m_fold->setToolTip(tr("Fold or unfold"));
    row->addWidget(m_fold);
    auto* title = new QLabel(m_panel.title(), m_header);
    title->setFont(theme::headingFont());
    row->addWidget(title);
    auto* summary = new FittingLabel(Qt::AlignRight, m_header);
    summary->setText(m_panel.summary());
    summary->setFont(theme::smallFont());
    summary->setProperty("role", QStringLiteral("secondary"));
    summary->setContentsMargins(4, 0, 4, 0);
    row->addWidget(summary, 1);
    for (QAction* action : m_panel.actions()) {
        auto* button = new QToolButton(m_header);
        button->setDefaultAction(action);
        button->setIconSize(QSize(16, 16));
        button->setFixedSize(24, 22);
        row->addWidget(button);
    }
    m_place->setObjectName(QStringLiteral("floatPanel"));
    m_place->setIconSize(QSize(14, 14));
    m_place->setFixedSize(22, 22);
    row->addWidget(m_place);
    connect(&m_panel, &Panel::summaryChanged, summary, &QLabel::setText);
    connect(m_fold, &QToolButton::clicked, this, [this] { setFolded(!m_folded); });
    connect(m_place, &QToolButton::clicked, this, [this] { Q_EMIT floatRequested(!isFloating()); });
}

QString PanelSection::id() const
{
    return QString::fromLatin1(m_panel.metaObject()->className()).section(u':', -1);
}

QSize PanelSection::sizeHint() const
{
    const int width = std::max(this->width(), leastWidth);
    int height = headerHeight;
    if (!m_folded && m_panel.stretches())
        height += std::max(lowestList, m_panel.minimumSizeHint().height());
    else if (!m_folded)
        height += m_panel.hasHeightForWidth() ? m_panel.heightForWidth(width)
                                              : m_panel.sizeHint().height();
    return {leastWidth, height};
}

void PanelSection::setFolded(bool foldedNow)
{
    m_folded = foldedNow;
    m_panel.setVisible(!m_folded);
    // A folded list leaves the room to those that are open.
    setSizePolicy(QSizePolicy::Preferred,
        m_panel.stretches() && !m_folded ? QSizePolicy::Preferred : QSizePolicy::Fixed);
    updateGeometry();
    if (isFloating())
        resize(width(), sizeHint().height());
    m_fold->setIcon(
        stateIcon(m_folded ? QStringLiteral("chevron-right") : QStringLiteral("chevron-down")));
    Q_EMIT folded(m_folded);
}

void PanelSection::becomeWindow(QWidget* owner)
{
    // A tool window: over the main one, whose keys go on working.
    setParent(owner, Qt::Tool);
    const int height =
        m_panel.stretches() && !m_folded ? headerHeight + floatingList : sizeHint().height();
    resize(leastWidth, height);
    showPlace();
}

void PanelSection::becomePart(QWidget* parent)
{
    setParent(parent, Qt::Widget);
    showPlace();
}

void PanelSection::showPlace()
{
    m_place->setIcon(stateIcon(isFloating() ? QStringLiteral("dock") : QStringLiteral("undock")));
    m_place->setToolTip(isFloating() ? tr("Back into the window") : tr("Into a window of its own"));
}

bool PanelSection::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_header)
        return QWidget::eventFilter(watched, event);
    const auto* mouse = dynamic_cast<QMouseEvent*>(event);
    if (event->type() == QEvent::MouseButtonPress && mouse->button() == Qt::LeftButton) {
        m_pressed = mouse->position().toPoint();
    } else if (event->type() == QEvent::MouseMove && m_pressed) {
        const QPoint way = mouse->position().toPoint() - *m_pressed;
        if (way.manhattanLength() < 2 * QApplication::startDragDistance())
            return false;
        const QPoint grip = *m_pressed;
        m_pressed.reset();
        if (!isFloating()) {
            Q_EMIT floatRequested(true);
            move(mouse->globalPosition().toPoint() - grip);
        }
        // The window manager goes on with the drag.
        if (isFloating() && windowHandle())
            windowHandle()->startSystemMove();
    } else if (event->type() == QEvent::MouseButtonRelease && m_pressed) {
        m_pressed.reset();
        setFolded(!m_folded);
    }
    return false;
}

void PanelSection::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (event->oldSize().width() != event->size().width())
        updateGeometry();
}

void PanelSection::closeEvent(QCloseEvent* event)
{
    QWidget::closeEvent(event);
    // Later: what is closing now gets hidden, and may be closing with the whole program.
    if (isFloating())
        QMetaObject::invokeMethod(
            this, [this] { Q_EMIT floatRequested(false); }, Qt::QueuedConnection);
}

} // namespace ui
