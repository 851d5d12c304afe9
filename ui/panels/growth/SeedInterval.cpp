// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/SeedInterval.h"

#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/settings/SeedValues.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QScopedValueRollback>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ui {

namespace {

constexpr int stepsPerDeviation = 4; ///< of the slider
constexpr int tight = 4; ///< steps: one deviation
constexpr int loose = 20;
constexpr int usual = 10; ///< two and a half: of a normal distribution, 99 %
/// An end of the interval beyond which so little of the volume lies is open: nothing else is there.
constexpr double openBeyond = 0.005;

QLabel* word(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setFont(theme::smallFont());
    label->setProperty("role", QStringLiteral("secondary"));
    return label;
}

/// The parts of the volume below and above a value.
std::pair<double, double> beside(const core::Histogram& histogram, double value)
{
    const double all = std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0.0);
    const double range = histogram.maximum - histogram.minimum;
    if (all == 0.0 || range <= 0.0)
        return {1.0, 1.0};
    const double at = (value - histogram.minimum) / range * double(histogram.counts.size());
    double below = 0.0;
    for (std::size_t i = 0; i < histogram.counts.size(); ++i)
        below += histogram.counts[i] * std::clamp(at - double(i), 0.0, 1.0);
    return {below / all, (all - below) / all};
}

} // namespace

SeedInterval::SeedInterval(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
{
    build();
    m_segment = workspace.activeSegment();
    m_last = {workspace.growSettings().lower, workspace.growSettings().upper};
    connect(&workspace, &Workspace::growSettingsChanged, this, &SeedInterval::followSettings);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &SeedInterval::switchSegment);
    forget();
}

void SeedInterval::build()
{
    m_tolerance = new QSlider(Qt::Horizontal, this);
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
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(word(tr("tight"), this));
    layout->addWidget(m_tolerance, 1);
    layout->addWidget(word(tr("loose"), this));
    layout->addWidget(m_text);
    layout->addWidget(m_use);
    connect(m_use, &QToolButton::clicked, this, &SeedInterval::use);
    connect(m_tolerance, &QSlider::valueChanged, this, &SeedInterval::use);
}

void SeedInterval::forget()
{
    ++m_asked;
    m_voxels.clear();
    m_values.clear();
    m_sketched.reset();
    m_byHand.clear();
    m_intervals.clear();
    m_segment = m_workspace.activeSegment();
    if (const core::EditSession* session = m_workspace.session()) {
        for (const core::Segment& segment : session->document().segments)
            m_byHand.insert(segment.label);
    }
    showState();
}

void SeedInterval::switchSegment()
{
    const int before = m_segment;
    m_segment = m_workspace.activeSegment();
    if (before == m_segment)
        return;
    if (before == 0 && m_byHand.erase(0) > 0 && !m_intervals.contains(m_segment))
        m_byHand.insert(m_segment);
    const auto known = m_intervals.find(m_segment);
    if (known != m_intervals.end())
        set(known->second);
}

void SeedInterval::followSettings()
{
    const GrowSettings& settings = m_workspace.growSettings();
    const std::pair<double, double> interval(settings.lower, settings.upper);
    if (interval == m_last)
        return;
    m_last = interval;
    m_intervals[m_segment] = interval;
    if (!m_setting)
        m_byHand.insert(m_segment);
    Q_EMIT valuesChanged();
}

std::vector<core::SeedSketch> SeedInterval::sketches() const
{
    std::vector<core::SeedSketch> sketches;
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return sketches;
    for (std::vector<glm::ivec3>& voxels : sketchedVoxels(*session, m_segment)) {
        const std::optional<glm::dvec3> inward = m_workspace.seeds().seenAlong(voxels);
        sketches.push_back({.voxels = std::move(voxels), .inward = inward});
    }
    return sketches;
}

void SeedInterval::ask()
{
    const std::vector<core::SeedSketch> sketched = sketches();
    std::vector<glm::ivec3> voxels;
    for (const core::SeedSketch& sketch : sketched)
        voxels.insert(voxels.end(), sketch.voxels.begin(), sketch.voxels.end());
    if (voxels == m_voxels)
        return;
    ++m_asked;
    m_voxels = voxels;
    m_values.clear();
    m_sketched.reset();
    showState();
    Q_EMIT valuesChanged();
    if (voxels.empty())
        return;
    const std::size_t seeds = voxels.size();
    const core::SketchInterval around(sketched, m_workspace.volume()->geometry.size);
    voxels.insert(voxels.end(), around.voxels().begin(), around.voxels().end());
    m_workspace.session()->questions().probe(std::move(voxels),
        [interval = QPointer<SeedInterval>(this), asked = m_asked, sketched, seeds](
            const core::Result<std::vector<core::ProbedVoxel>>& probes) {
            if (!interval || interval->m_asked != asked || !probes)
                return;
            std::vector<int> codes;
            codes.reserve(probes->size());
            for (const core::ProbedVoxel& probe : *probes)
                codes.push_back(probe.code);
            interval->take(sketched, codes, seeds);
        });
}

void SeedInterval::take(
    const std::vector<core::SeedSketch>& sketches, const std::vector<int>& codes, std::size_t seeds)
{
    const core::Volume& volume = *m_workspace.volume();
    for (std::size_t i = 0; i < seeds; ++i)
        m_values.push_back(volume.encoding.value(codes[i]));
    m_sketched = core::SketchInterval(sketches, volume.geometry.size)
                     .look({codes.begin() + std::ptrdiff_t(seeds), codes.end()});
    showState();
    if (maySetItself()) {
        if (const auto interval = offered())
            set(*interval);
    }
    Q_EMIT valuesChanged();
}

bool SeedInterval::maySetItself() const
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(m_segment) : nullptr;
    return segment && segment->voxels == 0 && !m_byHand.contains(m_segment);
}

std::optional<std::pair<double, double>> SeedInterval::offered() const
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume || !m_sketched)
        return std::nullopt;
    const core::CodeInterval codes =
        core::offeredInterval(*m_sketched, m_tolerance->value() * 256 / stepsPerDeviation);
    if (codes.low > codes.high)
        return std::nullopt;
    double lower = volume->encoding.value(codes.low);
    double upper = volume->encoding.value(codes.high);
    // Outwards to numbers with few digits: history and report name them.
    const double spread = std::max(upper - lower, 1e-9);
    const double step = std::pow(10.0, std::floor(std::log10(spread / 50.0)));
    lower = std::floor(lower / step) * step;
    upper = std::ceil(upper / step) * step;
    if (lower <= volume->minimum || beside(volume->histogram, lower).first < openBeyond)
        lower = volume->minimum;
    if (upper >= volume->maximum || beside(volume->histogram, upper).second < openBeyond)
        upper = volume->maximum;
    return std::pair(lower, upper);
}

void SeedInterval::set(std::pair<double, double> interval)
{
    const QScopedValueRollback<bool> setting(m_setting, true);
    GrowSettings settings = m_workspace.growSettings();
    settings.lower = interval.first;
    settings.upper = interval.second;
    m_workspace.setGrowSettings(settings);
}

void SeedInterval::use()
{
    showState();
    const auto interval = offered();
    if (!interval)
        return;
    m_byHand.erase(m_segment);
    set(*interval);
    Q_EMIT intervalTaken();
}

bool SeedInterval::hasGrown() const
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(m_segment) : nullptr;
    return !segment || segment->voxels > 0;
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
            ? tr("No seed lies in the interval: nothing would grow. %1").arg(link)
            : tr("%1 of %2 seeds lie outside the interval. %3").arg(outside).arg(seeds).arg(link));
}

void SeedInterval::showState()
{
    const bool known = m_sketched && m_sketched->voxels > 0;
    m_use->setEnabled(known);
    m_tolerance->setEnabled(known);
    m_text->setText(
        tr("± %1 σ").arg(QLocale().toString(double(m_tolerance->value()) / stepsPerDeviation)));
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
