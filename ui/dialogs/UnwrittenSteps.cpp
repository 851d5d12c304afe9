// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/UnwrittenSteps.h"

#include "ui/ErrorText.h"
#include "ui/Workspace.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace ui {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("ui::UnwrittenSteps", text);
}

} // namespace

bool mayLoseUnwrittenSteps(Workspace& workspace, QWidget* parent)
{
    const core::EditSession* session = workspace.session();
    const std::optional<core::Error> trouble = session ? session->diskTrouble() : std::nullopt;
    if (!trouble)
        return true;
    QMessageBox box(QMessageBox::Warning, tr("Not on disk yet"),
        tr("The last steps could not be written.\n%1").arg(errorText(*trouble)),
        QMessageBox::Cancel, parent);
    box.setInformativeText(
        tr("They are lost when the window closes. Once there is room on the disk they are written "
           "within seconds."));
    const QPushButton* lose =
        box.addButton(tr("Close and lose them"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == lose;
}

} // namespace ui
