// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/GrowthPanel.h"

#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/session/past/RecentGrowth.h"
#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/segment/PreviewBox.h"
#include "ui/menus/EditableButton.h"
#include "ui/overlays/SeedBand.h"
#include "ui/panels/growth/GenerationSection.h"
#include "ui/panels/growth/GenerationText.h"
#include "ui/panels/growth/GrowCriteriaSection.h"
#include "ui/panels/growth/GrowthButtons.h"
#include "ui/panels/growth/LeakSection.h"
#include "ui/panels/growth/PinholeOffer.h"
#include "ui/panels/growth/PlainLimits.h"
#include "ui/panels/growth/SeedInterval.h"
#include "ui/panels/growth/SpreadBar.h"
#include "ui/panels/growth/ToleranceSection.h"
#include "ui/tasks/growth/GrowthGhost.h"
#include "ui/tasks/growth/GrowthRun.h"
#include "ui/tasks/growth/LiveInterval.h"
#include "ui/tools/growth/SeedTool.h"
#include "ui/widgets/FittingLabel.h"
#include "ui/widgets/HistogramRange.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

GrowthPanel::GrowthPanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_run(new GrowthRun(workspace, this))
{
    build();
    connect(m_run, &GrowthRun::begun, m_leak, [this] { m_leak->showAlarm({}); });
    connect(m_run, &GrowthRun::alarmed, m_leak, &LeakSection::showAlarmOf);
    connect(m_run, &GrowthRun::begun, m_pinholes, &PinholeOffer::forget);
    connect(m_run, &GrowthRun::completed, m_pinholes,
        [this](const GrowthTurn& last) { m_pinholes->lookInto(grownIn(last, m_workspace)); });
    connect(m_run, &GrowthRun::changed, this, &GrowthPanel::showState);
    m_liveInterval = new LiveInterval(workspace, this);
    connect(m_liveInterval, &LiveInterval::progressed, this, &GrowthPanel::showState);
    connect(m_range, &HistogramRange::rangeEdited, this, &GrowthPanel::takeSettings);
    connect(m_band, &SeedBand::changed, this, [this] {
        const SeedStretches shown = m_band->stretches().value_or(SeedStretches());
        m_range->setBands(shown.values, shown.newest);
    });
    connect(m_range, &HistogramRange::rangeEdited, this, &GrowthPanel::followInterval);
    connect(m_range, &HistogramRange::rangeSettled, this, &GrowthPanel::settleInterval);
    connect(m_range, &HistogramRange::rangeCancelled, m_liveInterval, &LiveInterval::cancel);
    connect(m_live, &QCheckBox::toggled, this, &GrowthPanel::showState);
    connect(m_pace, &QComboBox::activated, this, &GrowthPanel::takeSettings);
    connect(m_overwrite, &QCheckBox::toggled, this, &GrowthPanel::takeSettings);
    connect(m_step, &QPushButton::clicked, this, &GrowthPanel::step);
    connect(m_play, &QPushButton::clicked, this, &GrowthPanel::playOrPause);
    connect(m_toClosure, &QPushButton::clicked, this, &GrowthPanel::runToClosure);
    connect(m_resume, &QPushButton::clicked, this, &GrowthPanel::resume);
    connect(m_shrink, &QPushButton::clicked, this, &GrowthPanel::shrinkStep);
    connect(m_toSeeds, &QPushButton::clicked, this, &GrowthPanel::shrinkToSeeds);
    connect(m_connectivity, &QComboBox::activated, this, &GrowthPanel::takeSettings);

    connect(&workspace, &Workspace::sessionChanged, this, &GrowthPanel::showVolume);
    connect(&workspace, &Workspace::growSettingsChanged, this, &GrowthPanel::showSettings);
    connect(&workspace, &Workspace::activeSegmentChanged, this, [this] {
        m_fromSeeds->ask();
        showState();
        Q_EMIT summaryChanged(summary());
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History) {
                m_fromSeeds->followHistory();
                m_fromSeeds->ask();
            }
            showState();
            Q_EMIT summaryChanged(summary());
        });
    showVolume();
}

void GrowthPanel::build()
{
    m_band = new SeedBand(m_workspace, this);
    m_criteria = new GrowCriteriaSection(m_workspace, *m_band, this);
    m_range = new HistogramRange(this);
    m_range->setObjectName(QStringLiteral("growthInterval"));
    m_intervalChange = new FittingLabel(Qt::AlignLeft, this);
    m_intervalChange->setObjectName(QStringLiteral("growIntervalChange"));
    m_intervalChange->setFont(theme::smallFont());
    m_intervalChange->setMinimumHeight(m_intervalChange->fontMetrics().height());
    m_fromSeeds = new SeedInterval(m_workspace, this);
    connect(m_fromSeeds, &SeedInterval::valuesChanged, this, [this] {
        m_range->setMarkers(m_fromSeeds->values());
        m_range->showRange();
        showState();
    });
    connect(m_fromSeeds, &SeedInterval::intervalTaken, this, [this] {
        m_range->zoomToRange();
        followInterval();
        settleInterval();
    });
    // The traced tolerance stands in place of the slider: both set the interval around the seeds.
    auto* tolerance = new ToleranceSection(m_workspace, this);
    m_fromSeeds->addButton(tolerance->takeButton());
    connect(tolerance, &ToleranceSection::barShown, m_fromSeeds, &SeedInterval::setReplaced);
    m_step = transportButton(this, QStringLiteral("growStep"), QStringLiteral("step"), tr("Step"));
    m_step->setToolTip(tr("Grow by one generation"));
    m_play = transportButton(this, QStringLiteral("growPlay"), QStringLiteral("play"), tr("Grow"));
    m_play->setDefault(true);
    m_toClosure =
        transportButton(this, QStringLiteral("growToClosure"), QStringLiteral("to-end"), tr("All"));
    m_toClosure->setToolTip(tr("Grow until nothing is left within the interval"));
    // No pictures on these: the panel is narrow, and the words must be whole.
    m_shrink = narrowButton(this, QStringLiteral("growShrink"), tr("Shrink"));
    m_shrink->setToolTip(tr("Take back the last generation; hold it down for more"));
    m_shrink->setAutoRepeat(true);
    m_toSeeds = narrowButton(this, QStringLiteral("growToSeeds"), tr("To seeds"));
    m_toSeeds->setToolTip(tr("Take back all that has grown; the accepted seeds stay"));
    m_resume = narrowButton(this, QStringLiteral("growResume"), tr("Resume"));
    m_resume->setToolTip(
        tr("Go on with the criteria of the growth before; seeds sketched since take part"));
    m_live = new QCheckBox(tr("live interval"), this);
    m_live->setObjectName(QStringLiteral("growLive"));
    m_live->setToolTip(
        tr("What has grown follows the interval while you move it: wider bounds recover voxels, "
           "narrower ones take them back with what hung on them. What is suspended is striped red, "
           "what is reached in the segment's colour"));
    m_live->setChecked(true);
    m_connectivity = new QComboBox(this);
    m_connectivity->setObjectName(QStringLiteral("growConnectivity"));
    m_connectivity->setFixedHeight(theme::controlHeight);
    m_connectivity->setToolTip(tr(
        "Voxels that grow into each other share a face (6 neighbours), a face or an edge (18), or "
        "a corner too (26)"));
    m_connectivity->addItem(tr("faces"), 6);
    m_connectivity->addItem(tr("edges"), 18);
    m_connectivity->addItem(tr("corners"), 26);
    m_pace = new QComboBox(this);
    m_pace->setObjectName(QStringLiteral("growPace"));
    m_pace->setFixedHeight(theme::controlHeight);
    m_pace->addItem(tr("full speed"), 0.0);
    for (const double pace : {60.0, 20.0, 5.0})
        m_pace->addItem(tr("%1 steps / s").arg(pace), pace);
    m_overwrite = new QCheckBox(tr("overwrite"), this);
    m_overwrite->setToolTip(tr("Take voxels of other segments that are not locked"));
    m_overwrite->setObjectName(QStringLiteral("growOverwrite"));
    m_advice = new QLabel(this);
    m_advice->setObjectName(QStringLiteral("growAdvice"));
    m_advice->setFont(theme::smallFont());
    m_advice->setWordWrap(true);
    m_turnsText = new QLabel(this);
    m_turnsText->setObjectName(QStringLiteral("growTurns"));
    m_turnsText->setFont(theme::smallFont());
    m_turnsText->setWordWrap(true);
    m_pinholes = new PinholeOffer(m_workspace, this);
    m_leak = new LeakSection(m_workspace, this);
    connect(m_leak, &LeakSection::goOnRequested, m_run, &GrowthRun::goOn);
    connect(m_leak, &LeakSection::growthLeft, m_run, &GrowthRun::forgetAlarm);
    m_progress = new FittingLabel(Qt::AlignLeft, this);
    m_progress->setObjectName(QStringLiteral("growProgress"));
    m_progress->setFont(theme::smallFont());
    m_progress->setProperty("role", QStringLiteral("secondary"));
    m_generations = new GenerationSection(m_workspace, this);
    connect(m_generations, &GenerationSection::scrubMoved, this, &GrowthPanel::showState);
    connect(m_leak, &LeakSection::alarmChanged, m_generations, &GenerationSection::showLeak);

    auto* transport = new QHBoxLayout;
    transport->setSpacing(theme::smallPadding);
    transport->addWidget(m_step, 2);
    transport->addWidget(m_play, 3);
    transport->addWidget(m_toClosure, 2);
    auto* back = new QHBoxLayout;
    back->setSpacing(theme::smallPadding);
    back->addWidget(m_shrink, 1);
    back->addWidget(m_toSeeds, 1);
    back->addWidget(m_connectivity, 1);
    auto* again = new QHBoxLayout;
    again->setSpacing(theme::smallPadding);
    again->addWidget(m_resume, 1);
    again->addWidget(m_live, 1);
    auto* pace = new QHBoxLayout;
    auto* paceLabel = new QLabel(tr("Pace"), this);
    paceLabel->setProperty("role", QStringLiteral("secondary"));
    pace->setSpacing(theme::smallPadding);
    pace->addWidget(paceLabel);
    pace->addWidget(m_pace, 1);
    pace->addWidget(m_overwrite);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(theme::padding, theme::smallPadding, theme::padding, theme::padding);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_advice);
    layout->addWidget(m_fromSeeds);
    layout->addWidget(tolerance);
    layout->addWidget(m_range);
    layout->addWidget(m_intervalChange);
    layout->addWidget(new PlainLimits(m_workspace, this));
    layout->addWidget(new EditableButton(m_workspace, this, EditableButton::In::Column));
    layout->addLayout(buildGhost());
    layout->addLayout(transport);
    layout->addWidget(m_turnsText);
    layout->addWidget(m_fromSeeds->note());
    layout->addWidget(m_pinholes);
    layout->addWidget(m_leak);
    layout->addLayout(back);
    layout->addLayout(again);
    layout->addWidget(m_criteria);
    layout->addLayout(pace);
    layout->addWidget(m_progress);
    layout->addWidget(m_generations);
    layout->addWidget(new SpreadBar(m_workspace, this));
}

/// The row of what a growth would take.
QLayout* GrowthPanel::buildGhost()
{
    m_ghostShown = new PreviewBox(QStringLiteral("growth"), this);
    m_ghostShown->setToolTip(
        tr("While you sketch seeds, show in all views roughly what a growth in this interval would "
           "take: large volumes are looked at coarsely, and criteria that this cannot tell are "
           "left out, which the line beside it says"));
    m_ghostText = new FittingLabel(Qt::AlignRight, this);
    m_ghostText->setObjectName(QStringLiteral("growthGhost"));
    m_ghostText->setFont(theme::smallFont());
    m_ghostText->setProperty("role", QStringLiteral("secondary"));

    auto* ghost = new QHBoxLayout;
    ghost->setSpacing(theme::smallPadding);
    ghost->addWidget(m_ghostShown);
    ghost->addWidget(m_ghostText, 1);
    m_ghost = new GrowthGhost(m_workspace, this);
    connect(
        m_ghost, &GrowthGhost::changed, this, [this] { m_ghostText->setText(m_ghost->words()); });
    connect(m_ghostShown, &PreviewBox::toggled, this, &GrowthPanel::followGhost);
    connect(m_fromSeeds, &SeedInterval::valuesChanged, this, &GrowthPanel::followGhost);
    connect(&m_workspace, &Workspace::growSettingsChanged, this, &GrowthPanel::followGhost);
    connect(&m_workspace, &Workspace::editableChanged, this, &GrowthPanel::followGhost);
    connect(&m_workspace, &Workspace::activeToolChanged, this, &GrowthPanel::followGhost);
    connect(&m_workspace, &Workspace::atToleranceChanged, this, &GrowthPanel::followGhost);
    connect(&m_workspace.seeds(), &PendingSeeds::updated, this, &GrowthPanel::followGhost);
    return ghost;
}

QString GrowthPanel::title() const
{
    return tr("Growth");
}

QString GrowthPanel::summary() const
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment =
        session ? session->document().segment(m_workspace.activeSegment()) : nullptr;
    return segment ? segment->name : QString();
}

core::GrowSteps GrowthPanel::growEdit() const
{
    return growthOf(growthTurns(m_workspace).front(), m_workspace);
}

bool GrowthPanel::running() const
{
    return m_run->running();
}

void GrowthPanel::showVolume()
{
    m_run->forget();
    m_fronts.clear();
    const core::Volume* volume = m_workspace.volume();
    setEnabled(volume != nullptr);
    if (volume) {
        m_range->setHistogram(volume->histogram, volume->unit);
        const Workspace::GrowSettings& settings = m_workspace.growSettings();
        // An interval of another study means nothing here: start with what the 3D view shows.
        const bool fits = settings.lower < settings.upper && settings.lower >= volume->minimum
            && settings.upper <= volume->maximum;
        if (!fits)
            m_fromSeeds->show(shownValues(m_workspace));
        takeRecentCriteria();
    }
    m_fromSeeds->forget();
    showSettings();
    m_range->showRange();
    m_fromSeeds->ask();
    showState();
    Q_EMIT summaryChanged(summary());
}

/// What a recipe has grown goes on by its own criteria; what a window has kept for the session
/// comes after this and wins (DisplayState).
void GrowthPanel::takeRecentCriteria()
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    if (const auto criteria = core::recentCriteria(session->history(), m_workspace.growthPlane())) {
        Workspace::GrowSettings settings = m_workspace.growSettings();
        takeCriteria(*criteria, settings);
        m_fromSeeds->show({criteria->lower, criteria->upper});
        m_workspace.setGrowSettings(settings);
    }
}

void GrowthPanel::showSettings()
{
    const Workspace::GrowSettings& settings = m_workspace.growSettings();
    m_range->setRange(settings.lower, settings.upper);
    const QSignalBlocker overwrite(m_overwrite);
    m_overwrite->setChecked(settings.overwriteUnlocked);
    m_pace->setCurrentIndex(std::max(0, m_pace->findData(settings.generationsPerSecond)));
    m_connectivity->setCurrentIndex(std::max(0, m_connectivity->findData(settings.connectivity)));
}

void GrowthPanel::takeSettings()
{
    Workspace::GrowSettings settings = m_workspace.growSettings();
    settings.lower = m_range->lower();
    settings.upper = m_range->upper();
    settings.overwriteUnlocked = m_overwrite->isChecked();
    settings.connectivity = m_connectivity->currentData().toInt();
    settings.generationsPerSecond = m_pace->currentData().toDouble();
    m_workspace.setGrowSettings(settings);
}

void GrowthPanel::followGhost()
{
    const bool isSketching =
        m_ghostShown->isChecked() && qobject_cast<SeedTool*>(m_workspace.activeTool());
    if (isSketching)
        m_ghost->prepare();
    // One foresight at a time: the tolerance bar shows the segment itself as it would be.
    const bool isWanted = isSketching && !running() && !m_workspace.atTolerance();
    m_ghost->follow(isWanted, !m_fromSeeds->isLooking());
    m_ghostText->setText(m_ghost->words());
}

void GrowthPanel::followInterval()
{
    const bool grown = m_fromSeeds->hasGrown() || m_liveInterval->follows();
    if (m_live->isChecked() && !running() && grown && m_liveInterval->possible())
        m_liveInterval->move(m_range->lower(), m_range->upper(), followingSegments(m_workspace));
}

void GrowthPanel::settleInterval()
{
    if (!m_liveInterval->follows())
        return;
    shareInterval(m_workspace);
    m_liveInterval->settle();
}

void GrowthPanel::step()
{
    core::EditSession* session = m_workspace.session();
    if (!session || running())
        return;
    core::GrowSteps edit = growEdit();
    edit.steps = 1;
    if (const auto applied = session->apply(edit); !applied)
        m_workspace.fail(applied.error());
}

void GrowthPanel::playOrPause()
{
    if (running())
        m_run->pause();
    else
        m_run->begin(growthTurns(m_workspace), m_workspace.growSettings().generationsPerSecond);
}

void GrowthPanel::resume()
{
    if (!running())
        m_run->resume();
}

void GrowthPanel::runToClosure()
{
    if (!running())
        m_run->begin(growthTurns(m_workspace), 0.0);
}

void GrowthPanel::shrinkStep()
{
    shrink(1);
}

void GrowthPanel::shrinkToSeeds()
{
    shrink({});
}

void GrowthPanel::shrink(std::optional<int> steps)
{
    core::EditSession* session = m_workspace.session();
    if (!session || running())
        return;
    if (const auto applied = session->apply(core::ShrinkSteps{
            .steps = steps, .plane = core::namedPlane(m_workspace.growthPlane())});
        !applied)
        m_workspace.fail(applied.error());
}

void GrowthPanel::showState()
{
    core::EditSession* session = m_workspace.session();
    const std::uint8_t plane = m_workspace.growthPlane();
    const GrowthPast::Known known =
        session ? m_workspace.seeds().past().of(*session, plane) : GrowthPast::Known();
    const int seeds = known.seeds;
    const bool allLocked = session && everySegmentLocked(session->document(), plane);
    const bool canGrow = running() || (seeds > 0 && !allLocked);
    m_step->setEnabled(canGrow && !running());
    m_play->setEnabled(canGrow);
    m_toClosure->setEnabled(canGrow && !running());
    const bool canShrink =
        session && session->document().generation(plane) > 1 && !allLocked && !running();
    const bool hasGrown = known.criteria.has_value();
    m_resume->setEnabled(canGrow && !running() && hasGrown);
    m_live->setEnabled(hasGrown);
    // It keeps its room while it has nothing to say, so that the buttons stay where they are.
    m_intervalChange->setVisible(hasGrown && m_live->isChecked());
    m_intervalChange->setText(m_liveInterval->words());
    m_shrink->setEnabled(canShrink);
    m_toSeeds->setEnabled(canShrink);
    // Dark on the accent, as its text is.
    m_play->setIcon(QIcon(tintedIcon(running() ? QStringLiteral("pause") : QStringLiteral("play"),
        canGrow ? theme::window : theme::secondary, 16, devicePixelRatioF())));
    m_play->setText(running() ? tr("Pause") : tr("Grow"));

    if (seeds == 0) {
        m_advice->setText(tr("No seeds yet: take the Seed tool and sketch on what belongs to the "
                             "segment."));
    } else if (running()) {
        m_advice->setText(tr("Growing; Pause keeps what has grown."));
    } else if (allLocked) {
        m_advice->setText(session->document().labelPlanes().size() > 1
                ? tr("Every segment of this label plane is locked: unlock the one that is to grow.")
                : tr("Every segment is locked: unlock the one that is to grow."));
    } else {
        m_advice->setText(m_fromSeeds->text(seeds));
    }

    m_fromSeeds->showNote(!running());
    const QString turns =
        canGrow && !running() ? textOf(growthTurns(m_workspace), m_workspace) : QString();
    m_turnsText->setText(turns);
    m_turnsText->setVisible(!turns.isEmpty());
    const core::GrowthProgress progress =
        session ? session->growthProgress() : core::GrowthProgress();
    if (progress.open)
        m_fronts = progress.frontSizes;
    const QString scrub = m_generations->scrubText();
    m_progress->setText(!scrub.isEmpty() ? scrub
            : session                    ? generationText(*session, plane, m_fronts)
                                         : QString());
    m_generations->show(progress);
    followGhost();
}

} // namespace ui
