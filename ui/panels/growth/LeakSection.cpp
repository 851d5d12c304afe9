// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/LeakSection.h"

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/history/MovedGrowth.h"
#include "core/session/EditSession.h"
#include "core/session/StepFindings.h"
#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/tasks/growth/GrowthTurns.h"
#include "ui/widgets/BringIntoView.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr int panelsTurnMilliseconds = 250;

constexpr double um2PerMm2 = 1.0e6;

/// A recipe of before may have counted voxels.
QString widthText(const core::LeakAlarm& alarm)
{
    if (alarm.areaUm2 == 0)
        return LeakSection::tr("%1 voxels").arg(countText(alarm.voxels));
    return LeakSection::tr("%1 mm²").arg(
        countText(std::int64_t(std::llround(double(alarm.areaUm2) / um2PerMm2))));
}

} // namespace

LeakSection::LeakSection(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_guard(new QCheckBox(tr("stop at leaks"), this))
    , m_factor(new NumberField(this))
    , m_area(new NumberField(this))
    , m_barriers(new QCheckBox(tr("show barriers"), this))
    , m_offer(new QWidget(this))
    , m_text(new QLabel(m_offer))
    , m_raised(new QLabel(this))
{
    m_guard->setObjectName(QStringLiteral("growGuard"));
    m_guard->setToolTip(
        tr("Growth stops where a front that came out of a narrow place gets wide quickly"));
    m_factor->setObjectName(QStringLiteral("growGuardFactor"));
    m_factor->setToolTip(tr(
        "How many times as wide as the narrow place a front may get: less stops sooner, and more "
        "often without need"));
    m_factor->setFixedHeight(theme::controlHeight);
    m_factor->setRange(leastGuard, greatestGuard);
    m_factor->setDecimals(1);
    m_factor->setSingleStep(0.1);
    m_factor->setPrefix(tr("at "));
    m_factor->setSuffix(tr(" × wider"));
    m_area->setObjectName(QStringLiteral("growGuardArea"));
    m_area->setToolTip(
        tr("How much wider besides: small vessels need less, else their leaks pass unseen"));
    m_area->setFixedHeight(theme::controlHeight);
    m_area->setRange(leastGuardAreaMm2, greatestGuardAreaMm2);
    m_area->setDecimals(1);
    m_area->setSingleStep(5.0);
    m_area->setPrefix(tr("by "));
    m_area->setSuffix(tr(" mm²"));
    m_barriers->setObjectName(QStringLiteral("growBarriers"));
    m_barriers->setToolTip(
        tr("What is shut to growth: stripes in slices, translucent in the 3D view"));
    m_text->setObjectName(QStringLiteral("leakText"));
    m_text->setFont(theme::smallFont());
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::RichText);
    connect(m_text, &QLabel::linkActivated, this, &LeakSection::showPlace);
    m_text->setStyleSheet(QStringLiteral("color: %1").arg(theme::caution.name()));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(theme::smallPadding);
    const auto add = [&](const char* name, const QString& text, const QString& tip,
                         void (LeakSection::*slot)()) {
        auto* button = new QPushButton(text, m_offer);
        button->setObjectName(QLatin1String(name));
        button->setProperty("role", QStringLiteral("narrow"));
        button->setFixedHeight(theme::rowHeight);
        button->setToolTip(tip);
        buttons->addWidget(button, 1);
        connect(button, &QPushButton::clicked, this, slot);
    };
    add("leakPlug", tr("Plug"),
        tr("Shut the narrow place, take back what lies beyond, and grow on elsewhere"),
        &LeakSection::plug);
    add("leakReject", tr("Reject"), tr("Take back what has grown since the narrow place"),
        &LeakSection::reject);
    add("leakAccept", tr("Accept"),
        tr("It is no leak: grow on, and ask again only where a front gets wider by twice as much"),
        &LeakSection::accept);
    auto* offer = new QVBoxLayout(m_offer);
    offer->setContentsMargins(0, 0, 0, 0);
    offer->setSpacing(theme::smallPadding);
    offer->addWidget(m_text);
    offer->addLayout(buttons);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    auto* switches = new QHBoxLayout;
    switches->setSpacing(theme::smallPadding);
    switches->addWidget(m_guard, 1);
    switches->addWidget(m_barriers);
    layout->addLayout(switches);
    // Both widths are the guard's: nothing else stands in their row.
    auto* widths = new QHBoxLayout;
    widths->setSpacing(theme::smallPadding);
    widths->addWidget(m_factor, 1);
    widths->addWidget(m_area, 1);
    layout->addLayout(widths);
    m_raised->setObjectName(QStringLiteral("leakRaised"));
    m_raised->setFont(theme::smallFont());
    m_raised->setWordWrap(true);
    m_raised->setTextFormat(Qt::RichText);
    m_raised->setProperty("role", QStringLiteral("secondary"));
    connect(m_raised, &QLabel::linkActivated, this, &LeakSection::askAsBefore);
    layout->addWidget(m_raised);
    layout->addWidget(m_offer);
    m_offer->hide();
    connect(m_guard, &QCheckBox::toggled, this, &LeakSection::takeSettings);
    connect(m_factor, &QDoubleSpinBox::valueChanged, this, &LeakSection::takeSettings);
    connect(m_area, &QDoubleSpinBox::valueChanged, this, &LeakSection::takeSettings);
    connect(m_barriers, &QCheckBox::toggled, this, [this](bool shown) {
        Workspace::ViewOptions options = m_workspace.viewOptions();
        options.showBarriers = shown;
        m_workspace.setViewOptions(options);
    });
    connect(&workspace, &Workspace::viewOptionsChanged, this, &LeakSection::showBarriers);
    connect(&workspace, &Workspace::growSettingsChanged, this, &LeakSection::showSettings);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_shownGrowth = 0;
        m_answered.reset();
        showAlarm({});
        showRaised();
    });
    connect(&workspace, &Workspace::documentChanged, this, &LeakSection::follow);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &LeakSection::showBesideGrowth);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &LeakSection::showRaised);
    showSettings();
    showBarriers();
}

void LeakSection::showBarriers()
{
    const QSignalBlocker quiet(m_barriers);
    m_barriers->setChecked(m_workspace.viewOptions().showBarriers);
}

void LeakSection::showSettings()
{
    const GrowSettings& settings = m_workspace.growSettings();
    const GrowSettings::Limit& guard = settings.guard;
    const QSignalBlocker quietGuard(m_guard);
    const QSignalBlocker quietFactor(m_factor);
    const QSignalBlocker quietArea(m_area);
    m_guard->setChecked(guard.on);
    m_factor->setValue(guard.value);
    m_factor->setEnabled(guard.on);
    m_area->setValue(settings.guardAreaMm2);
    m_area->setEnabled(guard.on);
    showRaised();
}

void LeakSection::takeSettings()
{
    GrowSettings settings = m_workspace.growSettings();
    settings.guard = {.on = m_guard->isChecked(), .value = m_factor->value()};
    settings.guardAreaMm2 = m_area->value();
    m_workspace.setGrowSettings(settings);
}

void LeakSection::showAlarm(const std::optional<core::LeakAlarm>& alarm)
{
    m_plane = m_workspace.growthPlane();
    m_grew.reset();
    offer(alarm);
}

void LeakSection::showAlarmOf(const core::LeakAlarm& alarm, const GrowthTurn& burst)
{
    m_plane = core::growthPlaneOf(burst.plane);
    m_grew = growingLabels(burst.segments, m_plane, m_workspace);
    offer(alarm);
}

void LeakSection::offer(const std::optional<core::LeakAlarm>& alarm)
{
    m_alarm = alarm;
    m_stands = false;
    if (alarm)
        m_answered.reset();
    // Else the focus would go to whatever comes next in the panel.
    if (!alarm && m_offer->isAncestorOf(focusWidget()))
        m_guard->setFocus();
    m_offer->setVisible(alarm.has_value());
    showBesideGrowth();
    if (!alarm)
        return;
    m_text->setText(tr("A leak? Generation %1 burst out of a narrow place, %2 wide. %3")
                        .arg(countText(alarm->generation), widthText(*alarm),
                            QStringLiteral("<a href=\"show\" style=\"color: %1\">%2</a>")
                                .arg(theme::accent.name(), tr("Show\u00a0it"))));
    // In a panel that is scrolled away growth would seem to have ended by itself. Once more when
    // the panel has taken note that the growth has ended, since that shows other parts above this
    // one.
    for (const int milliseconds : {0, panelsTurnMilliseconds})
        QTimer::singleShot(milliseconds, m_offer, [this] { bringIntoView(*m_offer, *m_text); });
}

void LeakSection::showBesideGrowth()
{
    const bool isShown = m_alarm && m_plane == m_workspace.growthPlane();
    m_workspace.setWarnAfter(isShown ? std::optional(m_alarm->narrow) : std::nullopt);
    Q_EMIT alarmChanged(isShown ? m_alarm : std::nullopt);
}

/// A growth that ended with an alarm is told of once, however it was made. Undone, shrunk or grown
/// on by other means, there is nothing to decide any more.
void LeakSection::follow()
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    showRaised();
    const core::RowId row = session->history().position();
    const std::optional<core::LeakAlarm> alarm = session->findings().leakAlarm();
    if (alarm && row != std::exchange(m_shownGrowth, row) && alarm != m_alarm
        && alarm != std::exchange(m_answered, std::nullopt)) {
        showAlarm(alarm);
        Q_EMIT growthLeft();
    }
    if (!m_alarm)
        return;
    const std::uint8_t plane = alarm == m_alarm
        ? core::recordedGrowthPlane(session->history().row(row).edit, session->history())
        : m_plane;
    if (std::exchange(m_plane, plane) != plane)
        showBesideGrowth();
    const bool there = session->document().generation(m_plane) == m_alarm->generation;
    if (m_stands && !there)
        showAlarm({});
    else
        m_stands = there;
}

void LeakSection::apply(const core::Edit& edit)
{
    if (const auto applied = m_workspace.session()->apply(edit); !applied)
        m_workspace.fail(applied.error());
}

void LeakSection::showPlace()
{
    if (m_alarm)
        m_workspace.setCrosshairLps(
            m_workspace.volume()->geometry.toWorld(glm::dvec3(m_alarm->voxel)));
}

void LeakSection::showRaised()
{
    const std::optional<double> areaMm2 = raisedAreaMm2(m_workspace);
    m_raised->setVisible(areaMm2.has_value());
    if (areaMm2)
        m_raised->setText(tr("You accepted a front: in this segment growth asks again only where "
                             "one gets wider by %1 mm². %2")
                              .arg(countText(std::int64_t(std::llround(*areaMm2))),
                                  QStringLiteral("<a href=\"ask\" style=\"color: %1\">%2</a>")
                                      .arg(theme::accent.name(), tr("Ask\u00a0as\u00a0before"))));
}

void LeakSection::askAsBefore()
{
    for (const GrowthTurn& turn : growthTurns(m_workspace)) {
        if (activeGrows(turn, m_workspace))
            m_workspace.seeds().acceptedFronts().forget(
                growingLabels(turn.segments, m_workspace.growthPlane(), m_workspace));
    }
    showRaised();
}

std::vector<int> LeakSection::alarmedLabels() const
{
    if (m_grew)
        return *m_grew;
    const core::EditSession& session = *m_workspace.session();
    const std::optional<core::GrowCriteria> criteria =
        m_workspace.seeds().past().of(session, m_plane).criteria;
    std::vector<int> labels =
        growingLabels(criteria ? criteria->segments : std::nullopt, m_plane, m_workspace);
    // One that was sketched since the alarm has no part in it.
    std::erase_if(labels, [&session](int label) {
        const core::Segment* segment = session.document().segment(label);
        return !segment || segment->voxels == 0;
    });
    return labels;
}

/// A growth that is no row yet is not asked about once more when it is one.
void LeakSection::endOffer()
{
    if (m_workspace.session()->findings().leakAlarm() != m_alarm)
        m_answered = m_alarm;
    showAlarm({});
}

void LeakSection::accept()
{
    const std::uint8_t plane = m_plane;
    m_workspace.seeds().acceptedFronts().accept(
        *m_alarm, plane, alarmedLabels(), *m_workspace.session());
    showRaised();
    endOffer();
    Q_EMIT goOnRequested(plane);
}

void LeakSection::reject()
{
    const core::LeakAlarm alarm = *m_alarm;
    const std::uint8_t plane = m_plane;
    m_workspace.seeds().acceptedFronts().forget(alarmedLabels());
    showRaised();
    endOffer();
    apply(core::ShrinkSteps{
        .steps = int(alarm.generation - alarm.narrow), .plane = core::namedPlane(plane)});
    Q_EMIT growthLeft();
}

void LeakSection::plug()
{
    const core::LeakAlarm alarm = *m_alarm;
    const std::uint8_t plane = m_plane;
    endOffer();
    apply(
        core::PlugLeak{.pointLps = m_workspace.volume()->geometry.toWorld(glm::dvec3(alarm.voxel)),
            .plane = core::namedPlane(plane)});
    Q_EMIT goOnRequested(plane);
}

} // namespace ui
