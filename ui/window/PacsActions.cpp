// SPDX-License-Identifier: Apache-2.0
#include "ui/window/PacsActions.h"

#include "ui/pacs/PacsBrowserDialog.h"
#include "ui/pacs/PacsCache.h"
#include "ui/pacs/SendDialog.h"
#include "ui/window/MainWindow.h"

#include <QFileDialog>
#include <QPointer>

namespace ui {

void addPacsActions(MainWindow& window)
{
    Actions& actions = window.actionTable();
    new CacheHolder(window.workspace());
    actions.add({.id = QStringLiteral("file.fromPacs"),
        .text = Actions::tr("From PACS …"),
        .tip = Actions::tr("Look for a study at a DICOM node or a DICOMweb server, download it, "
                           "open it"),
        .run = [&window, dialog = QPointer<PacsBrowserDialog>()]() mutable {
            if (!dialog) {
                dialog = new PacsBrowserDialog(&window);
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                QObject::connect(dialog, &PacsBrowserDialog::openRequested, &window,
                    [&window](const QString& folder) { window.opener().open(folder); });
            }
            // Not modal: a study may be read while the next one comes.
            dialog->show();
            dialog->raise();
            dialog->activateWindow();
        }});
    actions.add({.id = QStringLiteral("file.toPacs"),
        .text = Actions::tr("Send to PACS …"),
        .tip = Actions::tr("Store DICOM files, masks for example, at a node or server"),
        .run = [&window] {
            const QStringList files =
                QFileDialog::getOpenFileNames(&window, Actions::tr("Send DICOM files"), QString(),
                    Actions::tr("DICOM (*.dcm);;All files (*)"));
            if (files.isEmpty())
                return;
            auto* dialog = new SendDialog(files, &window);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            dialog->open();
        }});
}

} // namespace ui
