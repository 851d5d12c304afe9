// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/study/OpenDialogs.h"

#include "core/repair/SeriesRepair.h"
#include "ui/base/ErrorText.h"
#include "ui/dialogs/study/OpenStudyDialog.h"
#include "ui/dialogs/study/SpacingDialog.h"
#include "ui/frame/MessageBar.h"
#include "ui/settings/StudyOpener.h"
#include "ui/texts/ClauseText.h"

#include <QFileDialog>
#include <QFileInfo>

namespace ui {

namespace {

/// Whether what a session was made on is a folder; of pictures a folder, or one with all pages.
bool isFolder(const LostStudy& lost)
{
    const bool isOneFile = lost.why.arguments.value(1).contains(QLatin1String(".tif"));
    return lost.format.isEmpty() || lost.format == QLatin1String("DICOM")
        || (lost.format == QLatin1String("pictures") && !isOneFile);
}

QString volumeFilter()
{
    return QObject::tr("Volumes and archives (*.nii *.nii.gz *.hdr *.nrrd *.nhdr *.mha *.mhd *.dcm "
                       "*.tif *.tiff *.png *.zip *.7z *.tar *.tar.gz *.tgz);;All files (*)");
}

} // namespace

void askForFolder(StudyOpener& opener, QWidget& parent)
{
    const QString path =
        QFileDialog::getExistingDirectory(&parent, QObject::tr("Open a study: choose its folder"));
    if (!path.isEmpty())
        opener.open(path);
}

void askForFile(StudyOpener& opener, QWidget& parent)
{
    const QString path = QFileDialog::getOpenFileName(
        &parent, QObject::tr("Open a volume"), QString(), volumeFilter());
    if (!path.isEmpty())
        opener.open(path);
}

void askForSession(StudyOpener& opener, QWidget& parent)
{
    const QString path = QFileDialog::getOpenFileName(&parent, QObject::tr("Open a session"),
        QString(), QObject::tr("Sessions of Burin (*.burin);;All files (*)"));
    if (!path.isEmpty())
        opener.openSession(path);
}

void chooseVolume(
    const std::shared_ptr<const core::Study>& study, StudyOpener& opener, QWidget& parent)
{
    OpenStudyDialog dialog(study->listing(), &parent);
    if (dialog.exec() == QDialog::Accepted && !dialog.chosenKey().isEmpty())
        opener.open(study, dialog.chosenKey());
}

void askForSpacing(const std::shared_ptr<const core::Study>& study, const QString& series,
    StudyOpener& opener, QWidget& parent)
{
    SpacingDialog dialog(*study->listing().find(series), &parent);
    if (dialog.exec() == QDialog::Accepted)
        opener.open(study, core::withRepair(series, dialog.repair()));
}

void offerToFindStudy(const LostStudy& lost, MessageBar& bar, StudyOpener& opener, QWidget& parent)
{
    const core::Error& why = lost.why;
    const QString name = QFileInfo(lost.sessionFile).fileName();
    const QString problem = why.code == core::ErrorCode::StudyMissing
        ? QObject::tr("%1: its study is no longer at %2%3.")
              .arg(name, why.arguments.value(1),
                  why.arguments.size() > 2 ? QObject::tr(", and its own images cannot be used (%1)")
                                                 .arg(clauseText(why.arguments[2]))
                                           : QString())
        : errorText(why) + QLatin1Char('.');
    const auto ask = [file = lost.sessionFile, name, folder = isFolder(lost), &opener, &parent] {
        const QString title = QObject::tr("The study of %1").arg(name);
        const QString place = folder
            ? QFileDialog::getExistingDirectory(&parent, title)
            : QFileDialog::getOpenFileName(&parent, title, QString(), volumeFilter());
        if (!place.isEmpty())
            opener.openSession(file, place);
    };
    bar.show(MessageBar::Kind::Error,
        problem + QObject::tr(" Say where it is; it is checked before the session goes on."),
        QObject::tr("Choose its study …"), ask);
}

void answerQuestions(StudyOpener& opener, MessageBar& bar, QWidget& window)
{
    QObject::connect(
        &opener, &StudyOpener::choiceNeeded, &window,
        [&opener, &window](const auto& study) { chooseVolume(study, opener, window); },
        Qt::QueuedConnection);
    QObject::connect(
        &opener, &StudyOpener::spacingNeeded, &window,
        [&opener, &window](const auto& study, const QString& series) {
            askForSpacing(study, series, opener, window);
        },
        Qt::QueuedConnection);
    QObject::connect(&opener, &StudyOpener::sessionStudyNeeded, &window,
        [&opener, &bar, &window](
            const QString& file, const QString& format, const core::Error& why) {
            offerToFindStudy({file, format, why}, bar, opener, window);
        });
}

} // namespace ui
