// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/refine/DoubtsSection.h"

#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/workspace/Refinement.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr int mostDoubtRows = 4;

QString textOf(const SurfaceDoubts::Doubt& doubt)
{
    const QString area =
        DoubtsSection::tr("%1 cm²").arg(numberText(doubt.region.areaMm2 / 100.0, 1));
    return doubt.why == SurfaceDoubts::Doubt::Why::NoEdge
        ? DoubtsSection::tr("No edge there · %1").arg(area)
        : DoubtsSection::tr("Off the mask · %1").arg(area);
}

} // namespace

DoubtsSection::DoubtsSection(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_doubts(workspace)
    , m_look(new QPushButton(tr("Look for doubts"), this))
    , m_found(new QLabel(this))
    , m_list(new QListWidget(this))
{
    m_look->setObjectName(QStringLiteral("lookForDoubts"));
    m_look->setToolTip(
        tr("Where yellow follows the mask though grey values show no edge, and where "
           "green or red stands off the mask. Nothing is marked by itself"));
    m_found->setObjectName(QStringLiteral("doubtsFound"));
    m_found->setFont(theme::smallFont());
    m_found->setProperty("role", QStringLiteral("secondary"));
    m_list->setObjectName(QStringLiteral("surfaceDoubts"));
    m_list->setAccessibleName(tr("Doubts"));
    auto* row = new QHBoxLayout;
    row->setSpacing(theme::smallPadding);
    row->addWidget(m_look);
    row->addWidget(m_found, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addLayout(row);
    layout->addWidget(m_list);

    connect(m_look, &QPushButton::clicked, this, [this] { m_doubts.look(); });
    connect(&m_doubts, &SurfaceDoubts::changed, this, &DoubtsSection::show);
    connect(&m_doubts, &SurfaceDoubts::failed, &workspace, &Workspace::fail);
    const auto fly = [this](QListWidgetItem* item) {
        const auto& all = m_doubts.doubts();
        const int place = m_list->row(item);
        if (place >= 0 && std::size_t(place) < all.size())
            m_workspace.refinement().showRegion(all[std::size_t(place)].region);
    };
    connect(m_list, &QListWidget::itemClicked, this, fly);
    connect(m_list, &QListWidget::itemActivated, this, fly);
    show();
}

void DoubtsSection::show()
{
    const std::vector<SurfaceDoubts::Doubt>& all = m_doubts.doubts();
    m_list->clear();
    for (const SurfaceDoubts::Doubt& doubt : all)
        m_list->addItem(textOf(doubt));
    m_list->setVisible(!all.empty());
    const int rowHeight = std::max(m_list->sizeHintForRow(0), theme::controlHeight);
    m_list->setFixedHeight(
        rowHeight * std::clamp(m_list->count(), 1, mostDoubtRows) + 2 * m_list->frameWidth());
    m_look->setEnabled(!m_doubts.isLooking());
    const bool isClear = m_doubts.hasFound() && all.empty();
    m_found->setText(m_doubts.isLooking() ? tr("looking …") : isClear ? tr("none") : QString());
}

} // namespace ui
