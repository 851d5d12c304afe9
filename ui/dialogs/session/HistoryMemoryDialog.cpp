// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/session/HistoryMemoryDialog.h"

#include "ui/base/Theme.h"
#include "ui/settings/HistoryMemory.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/Workspace.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace ui {

HistoryMemoryDialog::HistoryMemoryDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent)
    , m_workspace(workspace)
    , m_mebibytes(new WholeNumberField(this))
{
    setWindowTitle(tr("Memory for history"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 16);
    layout->setSpacing(theme::smallPadding);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    auto* label = new QLabel(tr("History in memory"), this);
    label->setBuddy(m_mebibytes);
    m_mebibytes->setObjectName(QStringLiteral("historyMebibytes"));
    m_mebibytes->setRange(leastHistoryMebibytes, mostHistoryMebibytes);
    m_mebibytes->setSingleStep(64);
    m_mebibytes->setSuffix(tr(" MiB"));
    m_mebibytes->setAlignment(Qt::AlignRight);
    m_mebibytes->setMinimumWidth(130);
    m_mebibytes->setValue(historyMebibytes());
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addStretch(1);
    row->addWidget(m_mebibytes);
    auto* hint = new QLabel(
        tr("What the last steps changed is kept in memory up to here, so that undoing them\n"
           "waits for no disk. Older steps come from the session's file: nothing limits how\n"
           "far back you can go. From %1 to %2 MiB.")
            .arg(leastHistoryMebibytes)
            .arg(mostHistoryMebibytes),
        this);
    hint->setFont(theme::smallFont());
    hint->setProperty("role", QStringLiteral("secondary"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    layout->addLayout(row);
    layout->addWidget(hint);
    layout->addSpacing(theme::smallPadding);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void HistoryMemoryDialog::accept()
{
    setHistoryMebibytes(m_mebibytes->value());
    m_workspace.applyHistoryMemory();
    QDialog::accept();
}

} // namespace ui
