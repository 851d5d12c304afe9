// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/SeedInterval.h"

#include "core/session/EditSession.h"
#include "core/session/past/RecentGrowth.h"
#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/settings/growth/SeedValues.h"
#include "ui/tasks/growth/SketchLook.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr int stepsPerDeviation = 4; ///< of the slider
constexpr int tight = 4; ///< steps: one deviation
constexpr int loose = 20;
constexpr int usual = int(usualTolerance * stepsPerDeviation);
constexpr int takenMilliseconds = 500;

QLabel* word(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setFont(theme::smallFont());
    label->setProperty("role", QStringLiteral("secondary"));
    return label;
}

} // namespace

std::pair<double, double> shownValues(const Workspace& workspace)
{
    const core::Volume& volume = *workspace.volume();
    return {std::clamp(workspace.volumeDisplay().surfaceThreshold, volume.minimum, volume.maximum),
        volume.maximum};
}

SeedInterval::SeedInterval(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_look(new SketchLook(workspace, this))
{
    build();
    m_taken.setSingleShot(true);
    m_taken.setInterval(takenMilliseconds);
    connect(&m_taken, &QTimer::timeout, this, &SeedInterval::intervalTaken);
    connect(m_look, &SketchLook::found, this, &SeedInterval::take);
    m_segment = workspace.activeSegment();
    m_last = {workspace.growSettings().lower, workspace.growSettings().upper};
    connect(&workspace, &Workspace::growSettingsChanged, this, &SeedInterval::followSettings);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &SeedInterval::switchSegment);
    forget();
}

void SeedInterval::build()
{
    m_sliderRow = new QWidget(this);
    m_tolerance = new QSlider(Qt::Horizontal, m_sliderRow);
    m_tolerance->setObjectName(QStringLiteral("growTolerance"));
    m_tolerance->setRange(tight, loose);
    m_tolerance->setValue(usual);
    m_tolerance->setPageStep(2);
    m_tolerance->setToolTip(
        tr("How far values may lie from what was sketched: moves both ends of the interval"));
    m_tolerance->setAccessibleName(tr("Tolerance, tight to loose"));
    m_text = word({}, this);
    m_text->setObjectName(QStringLiteral("growToleranceText"));
    m_use = new QToolButton(this);
    m_use->setObjectName(QStringLiteral("intervalFromSeeds"));
    m_use->setFont(theme::smallFont());
    m_use->setText(tr("Use the seeds"));
    m_use->setToolTip(tr("Set the interval around what was sketched, at this tolerance"));
    m_use->setFixedHeight(theme::controlHeight);
    m_note = new QLabel(parentWidget());
    m_note->setObjectName(QStringLiteral("growOutside"));
    m_note->setFont(theme::smallFont());
    m_note->setWordWrap(true);
    m_note->setTextFormat(Qt::RichText);
    m_note->setStyleSheet(QStringLiteral("color: %1").arg(theme::caution.name()));
    connect(m_note, &QLabel::linkActivated, this, &SeedInterval::use);
    // In a narrow panel the slider needs a row of its own.
    auto* slider = new QHBoxLayout(m_sliderRow);
    slider->setContentsMargins(0, 0, 0, 0);
    slider->setSpacing(theme::smallPadding);
    slider->addWidget(word(tr("tight"), m_sliderRow));
    slider->addWidget(m_tolerance, 1);
    slider->addWidget(word(tr("loose"), m_sliderRow));
    m_buttons = new QHBoxLayout;
    m_buttons->setSpacing(theme::smallPadding);
    m_buttons->addWidget(m_text);
    m_buttons->addStretch(1);
    m_buttons->addWidget(m_use);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_sliderRow);
    layout->addLayout(m_buttons);
    connect(m_use, &QToolButton::clicked, this, &SeedInterval::use);
    connect(m_tolerance, &QSlider::valueChanged, this, &SeedInterval::moveTolerance);
    connect(m_tolerance, &QSlider::sliderReleased, this, &SeedInterval::use);
}

void SeedInterval::addButton(QWidget* button)
{
    m_buttons->addWidget(button);
}

void SeedInterval::setReplaced(bool replaced)
{
    // A hidden slider would never be let go of.
    if (replaced)
        m_tolerance->setSliderDown(false);
    m_sliderRow->setVisible(!replaced);
    m_text->setVisible(!replaced);
}

void SeedInterval::forget()
{
    m_look->drop();
    m_taken.stop();
    m_voxels.clear();
    m_asked = 0;
    m_values.clear();
    m_sketched.reset();
    m_segment = m_workspace.activeSegment();
    m_last = {m_workspace.growSettings().lower, m_workspace.growSettings().upper};
    showState();
}

SegmentIntervals& SeedInterval::intervals() const
{
    return m_workspace.seeds().intervals();
}

void SeedInterval::switchSegment()
{
    const int before = m_segment;
    m_segment = m_workspace.activeSegment();
    const core::EditSession* session = m_workspace.session();
    if (before == m_segment || !session || !m_workspace.volume())
        return;
    m_taken.stop();
    if (const auto first = before == 0 ? intervals().takeFirst() : std::nullopt;
        first && !intervals().of(m_segment))
        intervals().set(m_segment, *first);
    placeTolerance();
    const core::Segment* segment = session->document().segment(m_segment);
    if (const auto known = intervals().of(m_segment))
        show({known->lower, known->upper});
    else if (before != 0 && (!segment || segment->voxels == 0))
        show(shownValues(m_workspace));
}

void SeedInterval::followSettings()
{
    const GrowSettings& settings = m_workspace.growSettings();
    const std::pair<double, double> interval(settings.lower, settings.upper);
    if (interval == m_last)
        return;
    m_last = interval;
    if (!m_setting)
        intervals().setByHand(m_segment, interval.first, interval.second);
    Q_EMIT valuesChanged();
}

std::vector<core::SeedSketch> SeedInterval::sketches() const
{
    std::vector<core::SeedSketch> sketches;
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return sketches;
    for (const std::vector<glm::ivec3>& voxels : sketchedVoxels(*session, m_segment)) {
        // Pieces in different poses are looked at along different ways.
        const std::size_t first = sketches.size();
        for (const glm::ivec3& voxel : voxels) {
            const auto inward = m_workspace.seeds().seenAlong(m_segment, voxel);
            auto alike = std::find_if(sketches.begin() + std::ptrdiff_t(first), sketches.end(),
                [&inward](const core::SeedSketch& each) { return each.inward == inward; });
            if (alike == sketches.end())
                alike = sketches.insert(alike, {.voxels = {}, .inward = inward});
            alike->voxels.push_back(voxel);
        }
    }
    return sketches;
}

void SeedInterval::ask()
{
    std::vector<core::SeedSketch> sketched = sketches();
    std::vector<glm::ivec3> voxels;
    for (const core::SeedSketch& sketch : sketched)
        voxels.insert(voxels.end(), sketch.voxels.begin(), sketch.voxels.end());
    if (voxels == m_voxels)
        return;
    m_look->drop();
    m_sketchedAnew = m_asked == m_segment;
    m_asked = m_segment;
    m_voxels = std::move(voxels);
    m_values.clear();
    m_sketched.reset();
    showState();
    Q_EMIT valuesChanged();
    if (!m_voxels.empty())
        m_look->ask(std::move(sketched));
}

void SeedInterval::take(const core::SketchedCodes& sketched, const std::vector<int>& seeds)
{
    for (const int code : seeds)
        m_values.push_back(m_workspace.volume()->encoding.value(code));
    m_sketched = sketched;
    placeTolerance();
    // Whoever only comes back to a segment finds the interval that it had.
    if (maySetItself() && (m_sketchedAnew || !intervals().of(m_segment)))
        takeOffered();
    Q_EMIT valuesChanged();
}

bool SeedInterval::maySetItself() const
{
    const auto known = intervals().of(m_segment);
    return isFresh() && !(known && known->byHand);
}

bool SeedInterval::isFresh() const
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(m_segment) : nullptr;
    return segment && segment->voxels == 0;
}

std::optional<std::pair<double, double>> SeedInterval::offered() const
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume || !m_sketched)
        return std::nullopt;
    return offeredValues(*volume, *m_sketched, double(m_tolerance->value()) / stepsPerDeviation);
}

void SeedInterval::show(std::pair<double, double> interval)
{
    const QScopedValueRollback<bool> setting(m_setting, true);
    GrowSettings settings = m_workspace.growSettings();
    settings.lower = interval.first;
    settings.upper = interval.second;
    m_workspace.setGrowSettings(settings);
}

bool SeedInterval::hasGrown() const
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(m_segment) : nullptr;
    if (!segment)
        return true;
    // One that was painted or imported, or is locked, has no growth that could follow; one that a
    // change has withdrawn to nothing has.
    return !segment->locked && core::hasGrown(session->history(), *segment);
}

void SeedInterval::followHistory()
{
    const auto known = intervals().of(m_segment);
    if (!known || m_tolerance->isSliderDown())
        return;
    placeTolerance();
    show({known->lower, known->upper});
}

bool SeedInterval::takeOffered()
{
    const auto interval = offered();
    if (!interval)
        return false;
    intervals().set(m_segment,
        {.lower = interval->first,
            .upper = interval->second,
            .byHand = false,
            .tolerance = double(m_tolerance->value()) / stepsPerDeviation});
    show(*interval);
    return true;
}

void SeedInterval::moveTolerance()
{
    showState();
    if (takeOffered() && !m_tolerance->isSliderDown())
        m_taken.start();
}

/// Where the segment has it.
void SeedInterval::placeTolerance()
{
    if (!m_tolerance->isSliderDown()) {
        const auto known = intervals().of(m_segment);
        const double tolerance = known ? known->tolerance : usualTolerance;
        const QSignalBlocker silent(m_tolerance);
        m_tolerance->setValue(int(std::lround(tolerance * stepsPerDeviation)));
    }
    showState();
}

void SeedInterval::use()
{
    m_taken.stop();
    if (takeOffered())
        Q_EMIT intervalTaken();
}

void SeedInterval::showNote(bool wanted)
{
    const GrowSettings& settings = m_workspace.growSettings();
    const auto seeds = int(m_values.size());
    const auto outside = int(std::count_if(m_values.begin(), m_values.end(),
        [&settings](double value) { return value < settings.lower || value > settings.upper; }));
    // Edge voxels of a sketch are always outside; growth has enough to begin with.
    const bool shown = wanted && seeds > 0 && 4 * (seeds - outside) < seeds;
    m_note->setVisible(shown);
    if (!shown)
        return;
    const QString link = QStringLiteral("<a href=\"use\" style=\"color: %1\">%2</a>")
                             .arg(theme::accent.name(), tr("Use\u00a0the\u00a0seeds"));
    m_note->setText(outside == seeds
            ? (isFresh() ? tr("No seed lies in the interval: nothing would grow. %1")
                         : tr("No seed lies in the interval. %1"))
                  .arg(link)
            : tr("%1 of %2 seeds lie outside the interval. %3").arg(outside).arg(seeds).arg(link));
}

void SeedInterval::showState()
{
    const bool known = m_sketched && m_sketched->voxels > 0;
    m_use->setEnabled(known);
    m_tolerance->setEnabled(known);
    m_text->setText(
        tr("± %1 σ").arg(digitsText(double(m_tolerance->value()) / stepsPerDeviation, 6)));
}

QString SeedInterval::text(int seeds) const
{
    if (m_voxels.empty())
        return seeds == 1 ? tr("1 seed voxel, of another segment")
                          : tr("%1 seed voxels, all of other segments").arg(seeds);
    const QString count =
        m_voxels.size() == 1 ? tr("1 seed voxel") : tr("%1 seed voxels").arg(m_voxels.size());
    if (m_values.empty())
        return count;
    const SeedStatistics statistics = seedStatistics(m_values);
    return tr("%1 · %2 ± %3 %4")
        .arg(count, numberText(statistics.mean, 1), numberText(statistics.deviation, 1),
            m_workspace.volume()->unit)
        .trimmed();
}

} // namespace ui
