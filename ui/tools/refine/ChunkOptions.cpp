// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/refine/ChunkOptions.h"

#include "ui/base/Theme.h"
#include "ui/menus/EditableButton.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/Workspace.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

namespace ui {

ChunkOptions::ChunkOptions(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_count(new WholeNumberField(this))
    , m_bodies(new QComboBox(this))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    m_count->setObjectName(QStringLiteral("chunkCountBox"));
    m_count->setAccessibleName(tr("Chunks"));
    m_count->setFixedHeight(theme::controlHeight);
    m_count->setKeyboardTracking(false);
    m_count->setRange(Chunks::fewest, Chunks::most);
    m_count->setSuffix(tr(" chunks"));
    m_count->setToolTip(tr("Into how many the whole is divided"));
    layout->addWidget(m_count);
    layout->addWidget(new QLabel(tr("In 3D"), this));
    m_bodies->setObjectName(QStringLiteral("chunkBodiesBox"));
    m_bodies->setAccessibleName(tr("In 3D"));
    m_bodies->setFixedHeight(theme::controlHeight);
    m_bodies->addItems({tr("the segment's"), tr("and what looks like it"), tr("all")});
    layout->addWidget(m_bodies);
    layout->addWidget(new EditableButton(workspace, this));
    show();
    connect(&workspace.chunks(), &Chunks::lookChanged, this, &ChunkOptions::show);
    connect(m_count, &QSpinBox::valueChanged, this, &ChunkOptions::take);
    connect(m_bodies, &QComboBox::activated, this, &ChunkOptions::take);
}

void ChunkOptions::show()
{
    const QSignalBlocker count(m_count);
    m_count->setValue(m_workspace.chunks().look().count);
    m_bodies->setCurrentIndex(int(m_workspace.chunks().look().bodies));
}

void ChunkOptions::take()
{
    Chunks::Look look = m_workspace.chunks().look();
    look.count = m_count->value();
    look.bodies = Chunks::Bodies(m_bodies->currentIndex());
    m_workspace.chunks().setLook(look);
}

} // namespace ui
