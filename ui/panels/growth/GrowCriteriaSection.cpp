// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/GrowCriteriaSection.h"

#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/NumberText.h"
#include "ui/base/SmallLabel.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/overlays/SeedBand.h"
#include "ui/panels/growth/PlainLimits.h"
#include "ui/settings/growth/SeedValues.h"
#include "ui/widgets/FoldButton.h"
#include "ui/widgets/RangeSlider.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// As many as a value of this size needs to be told from its neighbours.
int decimalsFor(double value)
{
    return value >= 10.0 || value <= 0.0 ? 1 : std::clamp(int(2.0 - std::log10(value)), 1, 6);
}

/// "24.0 … 36.0 HU"; of several strokes "3 strokes: 24.0 … 36.0, 55.0 … 66.0 HU".
QString bandText(const SeedStretches& band, const QString& unit)
{
    constexpr std::size_t mostTold = 3;
    QStringList told;
    for (const auto& [lower, upper] : band.values) {
        if (told.size() < qsizetype(mostTold))
            told.append(
                GrowCriteriaSection::tr("%1 … %2").arg(numberText(lower, 1), numberText(upper, 1)));
    }
    QString values = QStringLiteral("%1 %2").arg(told.join(QStringLiteral(", ")), unit).trimmed();
    if (band.values.empty())
        values = GrowCriteriaSection::tr("no value of the interval");
    else if (band.values.size() > mostTold)
        values = GrowCriteriaSection::tr("%1 and %2 more")
                     .arg(values)
                     .arg(band.values.size() - mostTold);
    if (band.strokes + int(band.others) < 2)
        return values;
    const QString strokes = band.strokes == 1
        ? GrowCriteriaSection::tr("1 stroke")
        : GrowCriteriaSection::tr("%1 strokes").arg(band.strokes);
    return (band.others ? GrowCriteriaSection::tr("%1 and other seeds: %2")
                        : GrowCriteriaSection::tr("%1: %2"))
        .arg(strokes, values);
}

} // namespace

QString smoothNoiseName()
{
    return GrowCriteriaSection::tr("Smooth noise");
}

GrowCriteriaSection::GrowCriteriaSection(
    Workspace& workspace, const SeedBand& band, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_band(band)
{
    build();
    connect(&workspace, &Workspace::sessionChanged, this, &GrowCriteriaSection::showVolume);
    connect(&workspace, &Workspace::growSettingsChanged, this, &GrowCriteriaSection::showSettings);
    connect(&band, &SeedBand::changed, this, &GrowCriteriaSection::showBand);
    connect(&workspace, &Workspace::viewOptionsChanged, this, &GrowCriteriaSection::showSuspended);
    showVolume();
}

void GrowCriteriaSection::build()
{
    m_body = new QWidget(this);
    m_fold = new FoldButton(*m_body, this);
    m_fold->setObjectName(QStringLiteral("growCriteria"));
    m_fold->setToolTip(tr("What growth asks of voxels beside the interval"));
    auto* grid = new QGridLayout(m_body);
    grid->setContentsMargins(4, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(0, 1);
    addRow(&GrowSettings::sigmas, "growSigmas", tr("Strokes' mean ±"),
        tr("Narrow the interval, for each stroke of seeds by itself, to the mean of the values "
           "around its seeds ± so many standard deviations: of what lies within three voxels of a "
           "seed and in the interval. A segment takes what one of its strokes lets in; painted "
           "seeds are one stroke. The stretches are drawn on the histogram, that of the newest "
           "stroke stronger"));
    m_bandText = smallNote({}, m_body, Qt::AlignRight);
    m_bandText->setObjectName(QStringLiteral("growBandText"));
    m_bandText->setWordWrap(true);
    grid->addWidget(m_bandText, grid->rowCount(), 0, 1, 2);
    addRow(&GrowSettings::difference, "growDifference", tr("Step at most"),
        tr("A voxel's value differs by no more than this from that of the voxel it is reached "
           "from"));
    addRow(&GrowSettings::gradient, "growGradient", tr("Gradient at most"),
        tr("Growth stops where values change faster than this with the place: at edges"));
    addRow(&GrowSettings::gradientDifference, "growGradientDifference", tr("Gradient step"),
        tr("The gradient's magnitude differs by no more than this from that at the voxel it is "
           "reached from"));
    addRow(&GrowSettings::majority, "growMajority", smoothName(),
        tr("Of the 27 voxels around and at a voxel at least so many lie in the interval: keeps "
           "growth out of thin bridges and noise. In few steps it is above, too"));
    m_smoothing = addSwitch("growSmoothing", smoothNoiseName(),
        tr("Hold the interval against what is usual around a voxel, instead of its own value: the "
           "weighted median of the 27 voxels around and at it. Noise leaves no holes and lets in "
           "no specks, and borders stay where they are; threads one voxel thick are left out. All "
           "other criteria look at the voxels' own values"));
    addRow(&GrowSettings::passage, "growPassage", tr("Necks at least"),
        tr("Growth goes only where a ball of this diameter can roll to from a seed: through no "
           "narrower neck, and through no smaller hole in a wall, be it ever so thin. It is the "
           "width above, too"));
    m_onlyVisible = addSwitch("growOnlyVisible", tr("Only what is not carved"),
        tr("What sculpt layers have carved is closed to growth; muted layers do not count"));
    buildBox();
    buildSuspended();

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_fold, 0, Qt::AlignLeft);
    layout->addWidget(m_body);
}

void GrowCriteriaSection::addRow(GrowSettings::Limit GrowSettings::*limit, const char* name,
    const QString& text, const QString& tip)
{
    Row row{.limit = limit, .on = new QCheckBox(text, m_body), .value = new NumberField(m_body)};
    row.on->setObjectName(QLatin1String(name));
    row.on->setToolTip(tip);
    row.value->setObjectName(QLatin1String(name) + QStringLiteral("Value"));
    row.value->setAccessibleName(text);
    row.value->setToolTip(tip);
    row.value->setFixedHeight(theme::controlHeight);
    row.value->setFixedWidth(104);
    row.value->setButtonSymbols(QAbstractSpinBox::NoButtons);
    row.value->setAlignment(Qt::AlignRight);
    row.value->setKeyboardTracking(false);
    row.value->setStyleSheet(QStringLiteral("padding: 2px 3px"));
    auto* grid = static_cast<QGridLayout*>(m_body->layout());
    const int line = grid->rowCount();
    grid->addWidget(row.on, line, 0);
    grid->addWidget(row.value, line, 1);
    connect(row.on, &QCheckBox::toggled, this, [this, row] { change(row); });
    connect(row.value, &QDoubleSpinBox::valueChanged, this, [this, row] {
        // Who gives a value means it.
        const QSignalBlocker blocker(row.on);
        row.on->setChecked(true);
        change(row);
    });
    m_rows.push_back(row);
}

QCheckBox* GrowCriteriaSection::addSwitch(const char* name, const QString& text, const QString& tip)
{
    auto* on = new QCheckBox(text, m_body);
    on->setObjectName(QLatin1String(name));
    on->setMinimumHeight(theme::controlHeight); // as the rows with a value
    on->setToolTip(tip);
    connect(on, &QCheckBox::toggled, this, &GrowCriteriaSection::takeSwitches);
    auto* grid = static_cast<QGridLayout*>(m_body->layout());
    grid->addWidget(on, grid->rowCount(), 0, 1, 2);
    return on;
}

void GrowCriteriaSection::buildBox()
{
    auto* grid = static_cast<QGridLayout*>(m_body->layout());
    m_boxed = new QCheckBox(tr("Inside a box"), m_body);
    m_boxed->setObjectName(QStringLiteral("growBoxed"));
    m_boxed->setToolTip(tr("Growth stays inside a box, which is drawn in every view"));
    connect(m_boxed, &QCheckBox::toggled, this, &GrowCriteriaSection::takeSwitches);
    m_setBox = new QToolButton(m_body);
    m_setBox->setObjectName(QStringLiteral("growSetBox"));
    m_setBox->setFont(theme::smallFont());
    m_setBox->setText(tr("Set"));
    m_setBox->setFixedHeight(theme::controlHeight);
    m_setBox->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_setBox);
    menu->addAction(tr("Around the crosshair"), this,
        [this] { setBox(boxAround(m_workspace.crosshairLps())); });
    menu->addAction(tr("Around the seeds"), this, [this] {
        if (const auto box = boxAroundSeeds())
            setBox(*box);
        else
            m_workspace.say(tr("The active segment has no seeds to put a box around"));
    });
    menu->addAction(tr("As the clip box"), this, [this] { setBox(m_workspace.clip().box); });
    menu->addAction(tr("Whole volume"), this,
        [this] { setBox(core::wholeVolume(m_workspace.volume()->geometry).box); });
    m_setBox->setMenu(menu);
    const int line = grid->rowCount();
    grid->addWidget(m_boxed, line, 0);
    grid->addWidget(m_setBox, line, 1, Qt::AlignRight);

    m_boxBody = new QWidget(m_body);
    auto* axes = new QGridLayout(m_boxBody);
    axes->setContentsMargins(0, 0, 0, 0);
    axes->setHorizontalSpacing(4);
    axes->setVerticalSpacing(0);
    m_axes.build(m_boxBody, *axes, QStringLiteral("growBoxAxis"));
    for (int axis = 0; axis < 3; ++axis)
        connect(m_axes.of(axis), &RangeSlider::valuesEdited, this,
            [this, axis](double lower, double upper) { takeAxis(axis, lower, upper); });
    grid->addWidget(m_boxBody, line + 1, 0, 1, 2);
}

void GrowCriteriaSection::buildSuspended()
{
    m_suspended = new QCheckBox(tr("Suspended voxels in 3D"), m_body);
    m_suspended->setObjectName(QStringLiteral("growSuspended"));
    m_suspended->setMinimumHeight(theme::controlHeight);
    m_suspended->setToolTip(
        tr("What an interval suspends while it moves is shown in the 3D view, too, as a "
           "translucent, striped body. It stays marked when the interval is released, until "
           "something else is done; what another interval brings back of it is striped in red and "
           "the segment's colour"));
    connect(m_suspended, &QCheckBox::toggled, this, &GrowCriteriaSection::takeSuspended);
    auto* grid = static_cast<QGridLayout*>(m_body->layout());
    grid->addWidget(m_suspended, grid->rowCount(), 0, 1, 2);
    showSuspended();
}

void GrowCriteriaSection::showSuspended()
{
    const QSignalBlocker quiet(m_suspended);
    m_suspended->setChecked(m_workspace.viewOptions().suspendedBodies);
}

void GrowCriteriaSection::takeSuspended(bool shown)
{
    Workspace::ViewOptions options = m_workspace.viewOptions();
    options.suspendedBodies = shown;
    m_workspace.setViewOptions(options);
    // What was kept for the 3D view is of no use in slices either.
    if (core::EditSession* session = m_workspace.session(); session && !shown)
        session->questions().dropCutPreview();
}

void GrowCriteriaSection::showVolume()
{
    if (const core::Volume* volume = m_workspace.volume()) {
        GrowSettings settings = m_workspace.growSettings();
        chooseLimits(settings, *volume);
        m_workspace.setGrowSettings(settings);
        const QString unit =
            volume->unit.isEmpty() ? QString() : QStringLiteral(" ") + volume->unit;
        for (Row& row : m_rows) {
            const QSignalBlocker blocker(row.value);
            const double value = (settings.*row.limit).value;
            if (row.limit == &GrowSettings::sigmas) {
                row.value->setDecimals(2);
                row.value->setRange(0.01, 100.0);
                row.value->setSingleStep(0.25);
                row.value->setSuffix(tr(" σ"));
            } else if (row.limit == &GrowSettings::majority) {
                row.value->setDecimals(0);
                row.value->setRange(1.0, 27.0);
                row.value->setSuffix(tr(" of 27"));
            } else if (row.limit == &GrowSettings::passage) {
                showPassageWidths(*row.value, volume->geometry);
            } else {
                const bool gradient = row.limit != &GrowSettings::difference;
                row.value->setDecimals(decimalsFor(value));
                row.value->setRange(0.0, std::max(volume->maximum - volume->minimum, 1.0) * 10.0);
                row.value->setSingleStep(std::max(value / 10.0, 1e-6));
                row.value->setSuffix(gradient ? tr("%1 / mm").arg(unit) : unit);
            }
        }
        m_axes.showVolume(volume->geometry);
    }
    showSettings();
    showBand();
}

void GrowCriteriaSection::showSettings()
{
    const GrowSettings& settings = m_workspace.growSettings();
    for (const Row& row : m_rows) {
        const GrowSettings::Limit& limit = settings.*row.limit;
        const QSignalBlocker on(row.on);
        const QSignalBlocker value(row.value);
        row.on->setChecked(limit.on);
        row.value->setValue(limit.value);
    }
    const QSignalBlocker smoothing(m_smoothing);
    const QSignalBlocker visible(m_onlyVisible);
    const QSignalBlocker boxed(m_boxed);
    m_smoothing->setChecked(settings.smoothing);
    m_onlyVisible->setChecked(settings.onlyVisible);
    m_boxed->setChecked(settings.boxed);
    m_boxBody->setVisible(settings.boxed);
    const int on = limitsOn(settings);
    m_fold->setText(on == 0 ? tr("Criteria") : tr("Criteria · %1 on").arg(on));
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return;
    if (const auto box = growBoxOf(settings, volume->geometry))
        m_axes.showBox(*box, volume->geometry);
}

void GrowCriteriaSection::showBand()
{
    const auto& band = m_band.stretches();
    const core::Volume* volume = m_workspace.volume();
    m_bandText->setVisible(band.has_value());
    if (band && volume)
        m_bandText->setText(bandText(*band, volume->unit));
}

void GrowCriteriaSection::change(const Row& row)
{
    GrowSettings settings = m_workspace.growSettings();
    settings.*row.limit = {.on = row.on->isChecked(), .value = row.value->value()};
    m_workspace.setGrowSettings(settings);
}

void GrowCriteriaSection::takeSwitches()
{
    GrowSettings settings = m_workspace.growSettings();
    settings.smoothing = m_smoothing->isChecked();
    settings.onlyVisible = m_onlyVisible->isChecked();
    settings.boxed = m_boxed->isChecked();
    const core::Volume* volume = m_workspace.volume();
    if (volume && settings.boxed && !growBoxOf(settings, volume->geometry)) {
        const core::ClipRegion::Box& clip = m_workspace.clip().box;
        // Seeds outside would wait for ever, and nobody would see why.
        const auto place = clip.on ? std::optional(clip) : boxAroundSeeds();
        settings.box =
            growBoxFrom(place.value_or(boxAround(m_workspace.crosshairLps())), volume->geometry);
    }
    m_workspace.setGrowSettings(settings);
}

void GrowCriteriaSection::takeAxis(int axis, double lower, double upper)
{
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    const auto box = growBoxOf(m_workspace.growSettings(), geometry);
    if (!box)
        return;
    // To the nearest borders of voxels, at least one apart.
    const double spacing = geometry.spacingMm()[axis];
    core::ClipRegion::Box changed = *box;
    changed.minimum[axis] = std::round(lower / spacing) - 0.5;
    changed.maximum[axis] =
        std::max(std::round(upper / spacing) - 0.5, changed.minimum[axis] + 1.0);
    setBox(changed);
}

void GrowCriteriaSection::setBox(const core::ClipRegion::Box& box)
{
    GrowSettings settings = m_workspace.growSettings();
    settings.boxed = true;
    settings.box = growBoxFrom(box, m_workspace.volume()->geometry);
    m_workspace.setGrowSettings(settings);
}

/// Half as wide as the volume each way.
core::ClipRegion::Box GrowCriteriaSection::boxAround(const glm::dvec3& placeLps) const
{
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    const glm::dvec3 place = geometry.toIndex(placeLps);
    const glm::dvec3 quarter = 0.25 * glm::dvec3(geometry.size);
    const core::ClipRegion::Box whole = core::wholeVolume(geometry).box;
    return {.minimum = glm::clamp(place - quarter, whole.minimum, whole.maximum),
        .maximum = glm::clamp(place + quarter, whole.minimum, whole.maximum),
        .on = true};
}

std::optional<core::ClipRegion::Box> GrowCriteriaSection::boxAroundSeeds() const
{
    const core::EditSession* session = m_workspace.session();
    std::optional<core::ClipRegion::Box> box;
    if (!session)
        return box;
    for (const glm::ivec3& voxel : seedVoxels(*session, m_workspace.activeSegment())) {
        const auto around = boxAround(m_workspace.volume()->geometry.toWorld(glm::dvec3(voxel)));
        if (!box)
            box = around;
        box->minimum = glm::min(box->minimum, around.minimum);
        box->maximum = glm::max(box->maximum, around.maximum);
    }
    return box;
}

} // namespace ui
