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

/// If the session is still being saved with images, asks whether to wait for that.
/// @return whether it may be closed now
bool mayEndSaving(QWidget& window, SessionSaver& saver)
{
    bool written = true;
    const QObject watching;
    QObject::connect(&saver, &SessionSaver::imagesEnded, &watching,
        [&written](bool areWritten) { written = areWritten; });
    bool waits = false;
    while (saver.saving()) {
        QMessageBox box(QMessageBox::Question, tr("Still saving"),
            tr("The session is still being saved to %1, with the study's images.")
                .arg(saver.target()),
            QMessageBox::NoButton, &window);
        box.setInformativeText(waits
                ? tr("It is closed as soon as that is done.")
                : tr("If you cancel that, the session stays in the file that it has now, and none "
                     "is written there."));
        QPushButton* wait = waits ? nullptr : box.addButton(tr("Wait"), QMessageBox::AcceptRole);
        const QPushButton* give = box.addButton(tr("Cancel saving"), QMessageBox::DestructiveRole);
        QPushButton* stay = box.addButton(tr("Stay"), QMessageBox::RejectRole);
        box.setDefaultButton(wait ? wait : stay);
        box.setEscapeButton(stay);
        QObject::connect(&saver, &SessionSaver::imagesEnded, &box, &QDialog::reject);
        box.exec();
        if (!saver.saving())
            break;
        if (box.clickedButton() == give) {
            saver.cancel();
            return true;
        }
        if (!wait || box.clickedButton() != wait)
            return false;
        waits = true;
    }
    // What failed is told, and can be tried once more.
    return written;
}

} // namespace

bool mayLoseUnwrittenSteps(Workspace& workspace, QWidget& window, SessionSaver& saver)
{
    if (!mayEndSaving(window, saver))
        return false;
    // What is noticed only while the session is being closed could not be told to anybody.
    if (core::EditSession* session = workspace.session())
        session->storage().finishWriting();
    bool isEnded = false;
    while (true) {
        core::EditSession* session = workspace.session();
        const std::optional<core::Error> trouble =
            session ? session->storage().trouble() : std::nullopt;
        if (!trouble && (isEnded || !session))
            return true;
        if (!trouble) {
            // Only once the disk has all of what is done is the rest ended: whoever stays for the
            // sake of that keeps what is under way. Listeners hear what fails.
            isEnded = true;
            static_cast<void>(session->endWork());
            continue;
        }
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
