// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/refine/LikelySection.h"

#include "ui/base/NumberText.h"
#include "ui/base/SmallLabel.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/Workspace.h"

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

LikelySection::LikelySection(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_suggested(new QPushButton(this))
    , m_title(smallText(tr("Look here first"), this))
    , m_list(new QListWidget(this))
{
    m_suggested->setObjectName(QStringLiteral("chunksSuggested"));
    m_suggested->setToolTip(
        tr("With so many chunks, what looks most as if it were on the wrong side of the segment's "
           "border is a chunk by itself. A new division begins with it."));
    m_title->setProperty("role", QStringLiteral("secondary"));
    m_list->setObjectName(QStringLiteral("likelyChunks"));
    m_list->setAccessibleName(m_title->text());
    m_list->setToolTip(
        tr("The chunks that are most likely wrong, which have a rim in the pictures. A click leads "
           "the crosshair there; it changes nothing."));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_suggested);
    layout->addWidget(m_title);
    layout->addWidget(m_list);
    connect(m_suggested, &QPushButton::clicked, this, [this] {
        Chunks::Look look = m_workspace.chunks().look();
        look.count = m_workspace.chunks().suggestedCount().value_or(look.count);
        m_workspace.chunks().setLook(look);
    });
    const auto goThere = [this](QListWidgetItem* item) {
        const Chunks& chunks = m_workspace.chunks();
        const int place = m_list->row(item);
        if (place >= 0 && std::size_t(place) < chunks.likely().size())
            m_workspace.setCrosshairLps(chunks.placeLps(chunks.likely()[std::size_t(place)]));
    };
    connect(m_list, &QListWidget::itemClicked, this, goThere);
    connect(m_list, &QListWidget::itemActivated, this, goThere);
    connect(&workspace.chunks(), &Chunks::changed, this, &LikelySection::show);
    connect(&workspace.chunks(), &Chunks::lookChanged, this, &LikelySection::show);
    show();
}

void LikelySection::show()
{
    const Chunks& chunks = m_workspace.chunks();
    const std::optional<int> suggested = chunks.suggestedCount();
    m_suggested->setVisible(suggested.has_value());
    if (suggested) {
        m_suggested->setText(tr("Suggested: %1 chunks").arg(countText(*suggested)));
        m_suggested->setEnabled(*suggested != chunks.look().count);
    }
    QStringList rows;
    for (const Chunks::Likely& likely : chunks.likely()) {
        rows << (likely.isInside ? tr("%1 to take away?") : tr("%1 to add?"))
                    .arg(volumeText(*m_workspace.volume(), chunks.voxels(likely.chunk)));
    }
    m_list->clear();
    m_list->addItems(rows);
    m_title->setVisible(!rows.isEmpty());
    m_list->setVisible(!rows.isEmpty());
    const int rowHeight = std::max(m_list->sizeHintForRow(0), theme::controlHeight);
    m_list->setFixedHeight(rowHeight * std::max(1, m_list->count()) + 2 * m_list->frameWidth());
    setVisible(suggested || !rows.isEmpty());
}

} // namespace ui
