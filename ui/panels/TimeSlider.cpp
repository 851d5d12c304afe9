// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/TimeSlider.h"

#include "ui/base/Theme.h"
#include "ui/texts/ClauseText.h"
#include "ui/workspace/Workspace.h"

#include <QActionGroup>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <array>

namespace ui {

namespace {

constexpr std::array<double, 4> playedPerSecond{0.5, 1.0, 2.0, 5.0};

const core::SeriesAlternatives* pointsOf(const Workspace& workspace)
{
    const core::Volume* volume = workspace.volume();
    const core::SeriesAlternatives* points = volume ? volume->alternatives.get() : nullptr;
    return points && points->times.size() > 1 ? points : nullptr;
}

} // namespace

TimeSlider::TimeSlider(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_text(new QLabel(this))
    , m_slider(new QSlider(Qt::Horizontal, this))
    , m_open(new QPushButton(tr("Open"), this))
{
    m_text->setObjectName(QStringLiteral("timeText"));
    m_text->setFont(theme::smallFont());
    m_text->setProperty("role", QStringLiteral("secondary"));
    m_text->setWordWrap(true);
    m_slider->setObjectName(QStringLiteral("timeSlider"));
    m_slider->setAccessibleName(tr("Point in time"));
    m_slider->setToolTip(tr("A right click plays the points, leads to the first or the last one, "
                            "and copies which one this is"));
    m_slider->setContextMenuPolicy(Qt::CustomContextMenu);
    m_open->setObjectName(QStringLiteral("openTime"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_slider, 1);
    row->addWidget(m_open);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(row);
    layout->addWidget(m_text);
    connect(m_open, &QPushButton::clicked, this, [this] { Q_EMIT requested(m_slider->value()); });
    connect(m_slider, &QSlider::valueChanged, this, &TimeSlider::showChoice);
    connect(m_slider, &QWidget::customContextMenuRequested, this, &TimeSlider::openMenu);
}

void TimeSlider::showVolume()
{
    const core::SeriesAlternatives* points = pointsOf(m_workspace);
    setVisible(points != nullptr);
    if (!points)
        return;
    const QSignalBlocker blocker(m_slider);
    m_slider->setRange(0, int(points->times.size()) - 1);
    m_slider->setValue(points->time);
    showChoice();
}

void TimeSlider::showPlaying(bool isPlaying)
{
    m_isPlaying = isPlaying;
}

QString TimeSlider::chosenText() const
{
    const core::SeriesAlternatives* points = pointsOf(m_workspace);
    if (!points)
        return {};
    const QString label = clauseText(points->times.value(m_slider->value()));
    return tr("Point %1 of %2%3.")
        .arg(m_slider->value() + 1)
        .arg(points->times.size())
        .arg(label.isEmpty() ? QString() : QStringLiteral(", ") + label);
}

void TimeSlider::showChoice()
{
    const core::SeriesAlternatives* points = pointsOf(m_workspace);
    if (!points)
        return;
    const bool isOther = m_slider->value() != points->time;
    m_text->setText(chosenText()
        + (isOther ? tr(" Masks stay with the point that they were drawn on.")
                   : tr(" This one is open.")));
    m_open->setEnabled(isOther);
}

void TimeSlider::openMenu(const QPoint& at)
{
    const core::SeriesAlternatives* points = pointsOf(m_workspace);
    if (!points)
        return;
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("timeMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    // Its entries are about the points of this series. Playing goes on to others of the same, so
    // that the menu stays: it is there to pause it.
    connect(&m_workspace, &Workspace::sessionChanged, menu, [this, menu] {
        if (!m_isPlaying)
            menu->close();
    });
    QAction* play = menu->addAction(m_isPlaying ? tr("Pause") : tr("Play"), this, [this] {
        if (m_isPlaying)
            Q_EMIT pauseRequested();
        else
            Q_EMIT playRequested(m_pointsPerSecond);
    });
    play->setObjectName(QStringLiteral("playTimes"));
    play->setToolTip(m_isPlaying ? tr("Stays at the point that is open")
                                 : tr("Opens one point after the other, and after the last the "
                                      "first, until it is stopped or something is drawn"));
    addSpeeds(*menu->addMenu(tr("Speed")));
    menu->addSeparator();
    const int last = int(points->times.size()) - 1;
    QAction* toFirst =
        menu->addAction(tr("Open the first point"), this, [this] { Q_EMIT requested(0); });
    toFirst->setObjectName(QStringLiteral("firstTime"));
    toFirst->setEnabled(points->time != 0);
    QAction* toLast =
        menu->addAction(tr("Open the last point"), this, [this, last] { Q_EMIT requested(last); });
    toLast->setObjectName(QStringLiteral("lastTime"));
    toLast->setEnabled(points->time != last);
    menu->addSeparator();
    QString text = chosenText();
    text.chop(1); // the full stop
    QAction* copy = menu->addAction(
        tr("Copy '%1'").arg(text), this, [text] { QGuiApplication::clipboard()->setText(text); });
    copy->setObjectName(QStringLiteral("copyTime"));
    menu->popup(m_slider->mapToGlobal(at));
}

void TimeSlider::addSpeeds(QMenu& menu)
{
    auto* onlyOne = new QActionGroup(&menu);
    for (const double each : playedPerSecond) {
        QAction* action =
            menu.addAction(tr("%1 points per second at most").arg(each), this, [this, each] {
                m_pointsPerSecond = each;
                if (m_isPlaying)
                    Q_EMIT playRequested(each);
            });
        action->setCheckable(true);
        action->setChecked(each == m_pointsPerSecond);
        onlyOne->addAction(action);
    }
}

} // namespace ui
