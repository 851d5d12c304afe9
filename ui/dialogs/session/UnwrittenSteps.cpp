// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/session/UnwrittenSteps.h"

#include "core/session/SessionStorage.h"
#include "ui/base/ErrorText.h"
#include "ui/dialogs/session/SessionSaver.h"
#include "ui/workspace/Workspace.h"

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

bool mayLoseUnwrittenSteps(Workspace& workspace, QWidget& window, SessionSaver& saver)
{
    while (true) {
        core::EditSession* session = workspace.session();
        const std::optional<core::Error> trouble =
            session ? session->storage().trouble() : std::nullopt;
        if (!trouble)
            return true;
        const bool inMemory = session->storage().whyNoFile().has_value();
        QMessageBox box(QMessageBox::Warning, tr("Not on disk yet"),
            inMemory ? tr("Your steps are in memory only: %1.").arg(noFileText(*trouble))
                     : tr("The last steps could not be written.\n%1").arg(errorText(*trouble)),
            QMessageBox::NoButton, &window);
        box.setInformativeText(inMemory
                ? tr("They are lost if you go on. Save the session in a place that can be written "
                     "to keep them.")
                : tr("They are lost if you go on. Once there is room on the disk they are written "
                     "within seconds; or save the session in another place."));
        const QPushButton* lose =
            box.addButton(tr("Go on and lose them"), QMessageBox::DestructiveRole);
        const QPushButton* save = box.addButton(tr("Save session as …"), QMessageBox::ActionRole);
        QPushButton* stay = box.addButton(tr("Stay"), QMessageBox::RejectRole);
        box.setDefaultButton(stay);
        box.setEscapeButton(stay);
        box.exec();
        if (box.clickedButton() == lose)
            return true;
        if (box.clickedButton() != save)
            return false;
        // Whether it worked shows in what is still not written.
        static_cast<void>(saver.askAndWait());
    }
}

} // namespace ui
