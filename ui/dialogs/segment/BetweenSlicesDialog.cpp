// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/BetweenSlicesDialog.h"

#include "core/session/EditSession.h"
#include "ui/base/CountText.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/segment/SegmentWorkRow.h"
#include "ui/geometry/SlicePlane.h"
#include "ui/menus/EditableButton.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/widgets/FittingLabel.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QComboBox>
#include <QHideEvent>
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

} // namespace

BetweenSlicesDialog::BetweenSlicesDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent, Qt::Tool) // so that the window's keys, undo above all, work in it, too
    , m_workspace(workspace)
    , m_whose(new FittingLabel(Qt::AlignLeft, this))
    , m_axis(new QComboBox(this))
    , m_drawn(new FittingLabel(Qt::AlignLeft, this))
    , m_result(new QLabel(this))
    , m_work(new SegmentWorkRow(workspace, QStringLiteral("Between"), tr("Fill"), this))
{
    setWindowTitle(tr("Fill between slices"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 16);
    layout->setSpacing(theme::smallPadding);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    m_whose->setObjectName(QStringLiteral("betweenWhose"));
    m_whose->setFont(theme::headingFont());
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
    layout->addWidget(m_whose);
    layout->addWidget(m_axis);
    layout->addWidget(m_drawn);
    layout->addWidget(m_result);
    layout->addWidget(new EditableNote(workspace, this));
    layout->addSpacing(theme::smallPadding);
    layout->addWidget(m_work);
    m_lookSoon.setSingleShot(true);
    connect(&m_lookSoon, &QTimer::timeout, this, &BetweenSlicesDialog::look);
    connect(&m_fetch, &LabelFetch::finished, this, &BetweenSlicesDialog::count);
    connect(&m_fetch, &LabelFetch::failed, this, [this] {
        forget();
        showState();
    });
    connect(m_axis, &QComboBox::currentIndexChanged, this, [this] {
        if (m_planes)
            count(m_planes);
    });
    connect(m_work, &SegmentWorkRow::asked, this, &BetweenSlicesDialog::carryOut);
    connect(m_work, &SegmentWorkRow::looked, this, &BetweenSlicesDialog::showState);
    connect(m_work, &SegmentWorkRow::closed, this, &QDialog::reject);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (!isVisible())
                return;
            // The history also tells when a step is on the disk.
            if (change.what == core::DocumentChange::What::History
                && m_position != m_workspace.session()->history().position())
                m_lookSoon.start();
            showState();
        });
    connect(&workspace, &Workspace::sessionClosing, this, &BetweenSlicesDialog::forget);
    connect(&workspace, &Workspace::sessionChanged, this, &QDialog::reject);
}

void BetweenSlicesDialog::ask(int label)
{
    m_label = label;
    m_axis->setCurrentIndex(0);
    show();
    raise();
    activateWindow();
    m_work->focusApply();
    look();
}

void BetweenSlicesDialog::hideEvent(QHideEvent* event)
{
    if (!event->spontaneous())
        forget();
    QDialog::hideEvent(event);
}

/// The labels are as large as the volume: nobody keeps them who does not look at them.
void BetweenSlicesDialog::forget()
{
    m_lookSoon.stop();
    m_fetch.cancel();
    m_counting.cancel();
    m_planes.reset();
    m_found.reset();
    m_looking = false;
    m_position.reset();
}

void BetweenSlicesDialog::look()
{
    forget();
    core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(m_label) : nullptr;
    // What is open ends with a step, after which it is looked again.
    m_looking = segment && !session->transactionOpen();
    if (m_looking) {
        m_position = session->history().position();
        m_fetch.start(*session, {segment->plane});
    }
    showState();
}

void BetweenSlicesDialog::count(const LabelFetch::Planes& planes)
{
    m_planes = planes;
    m_found.reset();
    m_looking = true;
    m_counting.replace(
        this,
        [planes, geometry = m_workspace.volume()->geometry, label = std::uint8_t(m_label),
            axis = chosenAxis()](const core::Progress& progress) -> core::Result<Found> {
            const std::vector<std::uint8_t>& labels = planes->front().labels;
            Found found{.drawn = core::drawnSlices(labels, geometry.size, label), .axis = axis};
            if (!found.axis)
                found.axis = core::drawnAxis(found.drawn);
            if (!found.axis)
                return found;
            const auto between = core::voxelsBetween(labels, geometry, label,
                found.drawn.at(std::size_t(alongOf(*found.axis))), progress);
            if (!between)
                return tl::unexpected(between.error());
            found.voxels = std::int64_t(between->voxelCount());
            return found;
        },
        [this](const core::Result<Found>& found) {
            m_looking = false;
            if (found)
                m_found = *found;
            showState();
        });
    showState();
}

std::optional<core::SliceAxis> BetweenSlicesDialog::chosenAxis() const
{
    const int chosen = m_axis->currentIndex();
    if (chosen <= 0)
        return std::nullopt;
    return axisOf(m_workspace.volume()->geometry, orientations.at(std::size_t(chosen) - 1));
}

void BetweenSlicesDialog::showState()
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(m_label) : nullptr;
    m_whose->setText(segment ? segment->name : QString());
    QString why = whyUnchangeable(segment);
    if (why.isEmpty() && m_found && m_found->voxels == 0)
        why = tr("there is nothing to fill");
    m_work->showWhyNot(why);
    showFound();
}

void BetweenSlicesDialog::showFound()
{
    if (!m_found) {
        m_drawn->setText(QString());
        m_result->setText(m_looking ? tr("Looking …") : QString());
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
    const double millilitres =
        double(m_found->voxels) * m_workspace.volume()->geometry.voxelVolumeMm3() / 1000.0;
    m_result->setText(tr("Fills %1 empty slices: %2 voxels, %3")
                          .arg(countText(drawn.emptySlices()), countText(m_found->voxels),
                              volumeText(millilitres)));
}

QString BetweenSlicesDialog::drawnText(const core::DrawnSlices& drawn) const
{
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
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

void BetweenSlicesDialog::carryOut()
{
    fillBetweenSlices(m_workspace, {.segment = m_label, .axis = chosenAxis()});
    m_work->follow();
    showState();
}

} // namespace ui
