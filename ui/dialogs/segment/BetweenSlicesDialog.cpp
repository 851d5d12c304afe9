// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/BetweenSlicesDialog.h"

#include "core/edits/EditQuantise.h"
#include "core/edits/engine/SlicePlane.h"
#include "core/edits/kinds/filling/SketchPlanes.h"
#include "core/morphology/planes/BetweenPlanes.h"
#include "core/session/EditSession.h"
#include "core/session/past/DrawnPlanes.h"
#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/segment/PreviewRow.h"
#include "ui/dialogs/segment/SegmentWorkRow.h"
#include "ui/geometry/ViewPlane.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/widgets/FittingLabel.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QComboBox>
#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace ui {

namespace {

/// In the order of the list, behind the one that is found by itself.
constexpr std::array orientations{
    SliceOrientation::Axial, SliceOrientation::Coronal, SliceOrientation::Sagittal};

QString orientationText(SliceOrientation orientation)
{
    switch (orientation) {
    case SliceOrientation::Axial:
        return BetweenSlicesDialog::tr("axial");
    case SliceOrientation::Sagittal:
        return BetweenSlicesDialog::tr("sagittal");
    case SliceOrientation::Coronal:
        break;
    }
    return BetweenSlicesDialog::tr("coronal");
}

core::SliceAxis axisOf(const core::VolumeGeometry& geometry, SliceOrientation orientation)
{
    return axisAlong(geometry, sliceAxes(orientation).normalLps);
}

/// As the views number them, ascending: "3, 7–9, 14".
QString rangesText(std::vector<int> numbers)
{
    std::sort(numbers.begin(), numbers.end());
    QStringList ranges;
    for (std::size_t at = 0; at < numbers.size();) {
        std::size_t last = at;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1)
            ++last;
        ranges += last == at ? QString::number(numbers[at])
                             : QStringLiteral("%1–%2").arg(numbers[at]).arg(numbers[last]);
        at = last + 1;
    }
    return ranges.join(QStringLiteral(", "));
}

/// Those of the planes that do not only touch the segment up.
std::vector<core::DrawnPlane> drawnAsWhole(const std::vector<core::DrawnPlane>& planes,
    const std::vector<std::uint8_t>& labels, const core::VolumeGeometry& geometry, int label)
{
    const auto sketch = core::planeSketch(planes, geometry, QStringLiteral("fillBetweenSlices"));
    if (!sketch)
        return {};
    const std::vector<bool> whole =
        core::drawnAsWhole(labels, geometry.size, std::uint8_t(label), *sketch);
    std::vector<core::DrawnPlane> drawn;
    for (std::size_t at = 0; at < planes.size(); ++at) {
        if (whole[at])
            drawn.push_back(planes[at]);
    }
    return drawn;
}

} // namespace

BetweenSlicesDialog::BetweenSlicesDialog(Workspace& workspace, QWidget* parent)
    : LabelLookDialog(workspace, tr("Fill between slices"), QStringLiteral("between"), parent)
    , m_axis(new QComboBox(this))
    , m_drawn(new FittingLabel(Qt::AlignLeft, this))
    , m_result(new QLabel(this))
    , m_preview(new PreviewRow(workspace, QStringLiteral("between"), this))
    , m_work(new SegmentWorkRow(workspace, QStringLiteral("Between"), tr("Fill"), this))
{
    m_axis->setObjectName(QStringLiteral("betweenAxis"));
    m_axis->setAccessibleName(tr("Which slices"));
    m_axis->addItem(tr("The slices on which it was drawn"));
    for (const SliceOrientation each : orientations)
        m_axis->addItem(tr("Between %1 slices").arg(orientationText(each)));
    constexpr int textWidth = 380; // that nothing moves when the texts change
    m_drawn->setObjectName(QStringLiteral("betweenDrawn"));
    m_drawn->setFont(theme::smallFont());
    m_drawn->setMinimumWidth(textWidth);
    m_result->setObjectName(QStringLiteral("betweenResult"));
    m_result->setFont(theme::smallFont());
    m_result->setProperty("role", QStringLiteral("secondary"));
    column().addWidget(m_axis);
    column().addWidget(m_drawn);
    column().addWidget(m_result);
    addEditable();
    column().addSpacing(theme::smallPadding);
    column().addWidget(m_preview);
    column().addWidget(m_work);
    connect(m_axis, &QComboBox::currentIndexChanged, this, [this] {
        if (m_planes)
            count(m_planes);
    });
    connect(m_work, &SegmentWorkRow::asked, this, &BetweenSlicesDialog::carryOut);
    connect(m_work, &SegmentWorkRow::looked, this, &BetweenSlicesDialog::showState);
    connect(m_work, &SegmentWorkRow::closed, this, &QDialog::reject);
    connect(&workspace, &Workspace::editableChanged, this, &BetweenSlicesDialog::follow);
    connect(m_preview, &PreviewRow::switched, this, &BetweenSlicesDialog::follow);
    connect(m_preview, &PreviewRow::changed, this, [this] {
        m_work->follow();
        showState();
    });
}

void BetweenSlicesDialog::ask(int label)
{
    setLabel(label);
    m_axis->setCurrentIndex(0);
    bringUp();
    m_work->focusApply();
    look();
}

void BetweenSlicesDialog::forgetFound()
{
    m_planes.reset();
    m_found.reset();
    m_preview->preview(std::nullopt); // what is looked at next is the segment without it
}

void BetweenSlicesDialog::count(const LabelFetch::Planes& planes)
{
    m_planes = planes;
    m_found.reset();
    follow();
    lookThrough(
        [planes, geometry = workspace().volume()->geometry, edit = chosen(),
            strokes = planesOfStrokes()](const core::Progress& progress) -> core::Result<Found> {
            const std::vector<std::uint8_t>& labels = planes->front().labels;
            Found found{
                .drawn = core::drawnSlices(labels, geometry.size, std::uint8_t(edit.segment)),
                .axis = edit.axis};
            std::vector<core::DrawnPlane> drawn =
                drawnAsWhole(strokes, labels, geometry, edit.segment);
            if (!core::areAcrossOneAxis(drawn, geometry))
                found.planes = std::move(drawn);
            else if (!found.axis)
                found.axis = core::drawnAxis(found.drawn);
            const auto between = core::voxelsFilled(
                {.segment = edit.segment, .axis = found.axis, .planes = found.planes}, geometry,
                labels, progress);
            if (!between)
                return tl::unexpected(between.error());
            found.voxels = std::int64_t(between->voxelCount());
            return found;
        },
        [this](const Found& found) {
            m_found = found;
            follow();
        });
    showState();
}

std::optional<core::SliceAxis> BetweenSlicesDialog::chosenAxis() const
{
    const int chosen = m_axis->currentIndex();
    if (chosen <= 0)
        return std::nullopt;
    return axisOf(workspace().volume()->geometry, orientations.at(std::size_t(chosen) - 1));
}

std::vector<core::DrawnPlane> BetweenSlicesDialog::planesOfStrokes() const
{
    const core::EditSession* session = workspace().session();
    if (!session || m_axis->currentIndex() > 0)
        return {};
    const core::VolumeGeometry& geometry = workspace().volume()->geometry;
    std::vector<core::DrawnPlane> planes = core::drawnPlanes(label(), session->history(), geometry);
    if (core::areAcrossOneAxis(planes, geometry))
        return {};
    // Rounded as in the row, so that what is told is what is filled.
    return *core::quantised(
        core::FillBetweenSlices{.segment = label(), .planes = std::move(planes)})
                .get<core::FillBetweenSlices>()
                .planes;
}

void BetweenSlicesDialog::showState()
{
    LabelLookDialog::showState();
    QString why = whyUnchangeable(segment());
    if (why.isEmpty() && m_found && m_found->voxels == 0)
        why = tr("there is nothing to fill");
    m_work->showWhyNot(why);
    m_preview->showState(segment());
    showFound();
}

void BetweenSlicesDialog::showFound()
{
    if (!m_found) {
        m_drawn->setText(QString());
        m_result->setText(isLooking() ? tr("Looking …") : QString());
        return;
    }
    const QString filled = countedText(*workspace().volume(), m_found->voxels);
    if (m_found->planes) {
        m_drawn->setText(drawnText(*m_found->planes));
        m_result->setText(tr("Fills what lies between: %1").arg(filled));
        return;
    }
    if (!m_found->axis) {
        m_drawn->setText(tr("No slice between drawn ones is empty."));
        m_result->setText(
            tr("Draw the segment on some slices first, with empty ones between them."));
        return;
    }
    const core::DrawnSlices& drawn = m_found->drawn.at(std::size_t(alongOf(*m_found->axis)));
    m_drawn->setText(drawnText(drawn));
    m_result->setText(tr("Fills %1 empty slices: %2").arg(countText(drawn.emptySlices()), filled));
}

QString BetweenSlicesDialog::drawnText(const core::DrawnSlices& drawn) const
{
    const core::VolumeGeometry& geometry = workspace().volume()->geometry;
    for (const SliceOrientation each : orientations) {
        if (axisOf(geometry, each) != drawn.axis)
            continue;
        const SliceStack stack = sliceStack(geometry, sliceAxes(each).normalLps);
        glm::dvec3 middle = glm::dvec3(geometry.size - 1) / 2.0;
        std::vector<int> numbers;
        for (const int slice : drawn.slices) {
            middle[alongOf(drawn.axis)] = slice;
            numbers.push_back(stack.numberAt(geometry.toWorld(middle)) + 1);
        }
        return tr("Drawn: %1 slices %2").arg(orientationText(each), rangesText(numbers));
    }
    return tr("Drawn: %1 slices").arg(drawn.slices.size()); // of no standard plane
}

QString BetweenSlicesDialog::drawnText(const std::vector<core::DrawnPlane>& planes) const
{
    const core::VolumeGeometry& geometry = workspace().volume()->geometry;
    QStringList parts;
    std::size_t named = 0;
    for (const SliceOrientation each : orientations) {
        const SliceStack stack = sliceStack(geometry, sliceAxes(each).normalLps);
        std::vector<int> numbers;
        for (const core::DrawnPlane& plane : planes) {
            const auto onGrid =
                core::slicePlane(geometry, glm::normalize(plane.normalLps), plane.placeLps).onGrid;
            if (onGrid && onGrid->axis == alongOf(axisOf(geometry, each)))
                numbers.push_back(stack.numberAt(plane.placeLps) + 1);
        }
        named += numbers.size();
        if (!numbers.empty())
            parts += tr("%1 slices %2").arg(orientationText(each), rangesText(numbers));
    }
    if (const std::size_t oblique = planes.size() - named; oblique > 0)
        parts += oblique == 1 ? tr("1 oblique slice") : tr("%1 oblique slices").arg(oblique);
    return tr("Drawn: %1").arg(parts.join(QStringLiteral(" · ")));
}

core::FillBetweenSlices BetweenSlicesDialog::chosen() const
{
    return {.segment = label(),
        .axis = chosenAxis(),
        .planes = m_found ? m_found->planes : std::nullopt,
        .editable = workspace().editableRange()};
}

void BetweenSlicesDialog::follow()
{
    const bool isWanted =
        isVisible() && m_found && m_found->voxels > 0 && whyUnchangeable(segment()).isEmpty();
    m_preview->preview(isWanted ? std::optional<core::Edit>(chosen()) : std::nullopt);
}

void BetweenSlicesDialog::carryOut()
{
    const core::FillBetweenSlices edit = chosen();
    fillBetweenSlices(workspace(), edit, m_preview->handOver(edit));
    m_work->follow();
    showState();
}

} // namespace ui
