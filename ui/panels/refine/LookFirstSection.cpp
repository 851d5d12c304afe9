// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/refine/LookFirstSection.h"

#include "core/measure/MeasuredSize.h"
#include "ui/base/NumberText.h"
#include "ui/base/SmallLabel.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

QString placeText(const core::DoubtfulPlace& place, const core::Volume& in)
{
    using Why = core::DoubtfulPlace::Why;
    const QString volume =
        volumeText(in, std::llround(place.volumeMm3 / in.geometry.voxelVolumeMm3()));
    switch (place.why) {
    case Why::NoEdge:
        // Where the spacing is unknown, nobody has measured an area.
        if (core::unknownSpacing(in) != core::UnknownSpacing::Nothing)
            return LookFirstSection::tr("No edge");
        return LookFirstSection::tr("No edge · %1 cm²")
            .arg(numberText(place.areaMm2 / 100.0, place.areaMm2 < 100.0 ? 2 : 1));
    case Why::OnlyHere:
        return LookFirstSection::tr("Only here · %1").arg(volume);
    case Why::OnlyThere:
        break;
    }
    return LookFirstSection::tr("Only in the reference · %1").arg(volume);
}

} // namespace

LookFirstSection::LookFirstSection(
    Workspace& workspace, std::function<SegmentDoubts::Mask()> second, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_doubts(workspace)
    , m_second(std::move(second))
    , m_look(new QPushButton(this))
    , m_state(smallText({}, this))
    , m_list(new QListWidget(this))
{
    m_look->setObjectName(QStringLiteral("lookForPlaces"));
    m_look->setToolTip(
        tr("Places of the active segment that may be wrong: where its border follows no edge of "
           "the image, and where a reference from a file disagrees with it"));
    m_state->setObjectName(QStringLiteral("placesState"));
    m_state->setProperty("role", QStringLiteral("secondary"));
    m_list->setObjectName(QStringLiteral("placesToLookAt"));
    m_list->setAccessibleName(tr("Look here first"));
    m_list->setToolTip(tr("A click leads the crosshair there; a tick says that you have seen it. "
                          "Neither changes anything."));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    auto* row = new QHBoxLayout;
    row->setSpacing(theme::smallPadding);
    row->addWidget(m_look);
    row->addWidget(m_state, 1);
    layout->addLayout(row);
    layout->addWidget(m_list);

    connect(m_look, &QPushButton::clicked, this, &LookFirstSection::lookOrAbort);
    connect(&m_doubts, &SegmentDoubts::changed, this, &LookFirstSection::show);
    connect(&m_doubts, &SegmentDoubts::failed, &workspace, &Workspace::fail);
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        m_ticked = true;
        m_doubts.setSeen(std::size_t(m_list->row(item)), item->checkState() == Qt::Checked);
    });
    const auto goThere = [this](QListWidgetItem* item) {
        const SegmentDoubts::Found* found = m_doubts.found();
        const int place = m_list->row(item);
        if (!std::exchange(m_ticked, false) && found && place >= 0
            && std::size_t(place) < found->entries.size())
            m_workspace.setCrosshairLps(found->entries[std::size_t(place)].place.placeLps);
    };
    // A press begins anew: a tick by key is followed by no click.
    connect(m_list, &QListWidget::itemPressed, this, [this] { m_ticked = false; });
    connect(m_list, &QListWidget::itemClicked, this, goThere);
    connect(m_list, &QListWidget::itemActivated, this, [this, goThere](QListWidgetItem* item) {
        m_ticked = false;
        goThere(item);
    });
    show();
}

void LookFirstSection::lookOrAbort()
{
    if (m_doubts.isLooking())
        m_doubts.abort();
    else
        m_doubts.look(m_second ? m_second() : nullptr);
}

void LookFirstSection::lookOnce()
{
    const SegmentDoubts::Found* found = m_doubts.found();
    if (!m_doubts.isLooking() && (!found || found->editedSince))
        lookOrAbort();
}

QString LookFirstSection::stateText() const
{
    const SegmentDoubts::Found* found = m_doubts.found();
    if (m_doubts.isWaiting())
        return tr("waits until the open step is finished");
    if (m_doubts.isLooking())
        return tr("looking …");
    if (!found)
        return {};
    if (found->editedSince)
        return tr("before the last edits");
    return found->entries.empty() ? tr("nothing stands out") : QString();
}

void LookFirstSection::fill(const SegmentDoubts::Found& found)
{
    const auto count = int(found.entries.size());
    // Rows stay where they can, since the one that was just ticked is still being clicked on.
    while (m_list->count() > count)
        delete m_list->takeItem(m_list->count() - 1);
    while (m_list->count() < count)
        m_list->addItem(new QListWidgetItem);
    for (int i = 0; i < count; ++i) {
        const SegmentDoubts::Entry& entry = found.entries[std::size_t(i)];
        QListWidgetItem& item = *m_list->item(i);
        item.setText(placeText(entry.place, *m_workspace.volume()));
        item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item.setCheckState(entry.seen ? Qt::Checked : Qt::Unchecked);
        item.setForeground(entry.seen ? theme::secondary : theme::text);
    }
}

void LookFirstSection::show()
{
    const QSignalBlocker blocker(m_list);
    const SegmentDoubts::Found* found = m_doubts.found();
    fill(found ? *found : SegmentDoubts::Found());
    m_list->setVisible(m_list->count() > 0);
    const int rowHeight = std::max(m_list->sizeHintForRow(0), theme::controlHeight);
    m_list->setFixedHeight(rowHeight * std::max(1, m_list->count()) + 2 * m_list->frameWidth());
    m_look->setText(m_doubts.isLooking() ? tr("Abort") : tr("Look here first"));
    m_look->setEnabled(m_workspace.session()
        && m_workspace.session()->document().segment(m_workspace.activeSegment()));
    m_state->setText(stateText());
}

} // namespace ui
