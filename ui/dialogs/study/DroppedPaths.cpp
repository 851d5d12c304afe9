// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/study/DroppedPaths.h"

#include "core/archive/ArchiveReader.h"
#include "core/sessionfile/SessionFile.h"
#include "core/study/FileFormats.h"
#include "ui/frame/MessageBar.h"
#include "ui/settings/StudyOpener.h"
#include "ui/tasks/MaskImporter.h"

#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

#include <algorithm>

namespace ui {

namespace {

/// Whether a file is opened by itself, as a slice is not.
bool isWhole(const QString& path)
{
    return core::fileFormatOf(path) != nullptr || core::SessionFile::isNamedAt(path)
        || core::isArchive(path);
}

/// The folder of slices, or the first study.
QString studyAmong(const QStringList& paths)
{
    if (paths.size() == 1)
        return paths.front();
    // The header of a volume may come behind its file of voxels.
    const auto whole = std::find_if(paths.begin(), paths.end(), isWhole);
    if (whole != paths.end())
        return *whole;
    const QString folder = QFileInfo(paths.front()).absolutePath();
    const bool areOfOne = std::all_of(paths.begin(), paths.end(), [&folder](const QString& path) {
        const QFileInfo info(path);
        return info.isFile() && info.absolutePath() == folder;
    });
    return areOfOne ? folder : paths.front();
}

} // namespace

QStringList droppedPaths(const QMimeData& data)
{
    QStringList paths;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile())
            paths += url.toLocalFile();
    }
    return paths;
}

void takeDropped(const QStringList& paths, bool isStudyOpen, StudyOpener& opener,
    MaskImporter& importer, MessageBar& bar)
{
    const bool areMasks =
        isStudyOpen && std::all_of(paths.begin(), paths.end(), &MaskImporter::looksLikeMask);
    if (areMasks && paths.size() > 1)
        return bar.show(MessageBar::Kind::Caution,
            QObject::tr("None of the %1 masks was imported: drop one at a time, or the folder in "
                        "which they "
                        "lie.")
                .arg(paths.size()));
    if (areMasks)
        return importer.importDropped(paths.front());
    const QString path = studyAmong(paths);
    opener.open(path);
    if (paths.size() > 1 && paths.contains(path))
        bar.show(MessageBar::Kind::Caution,
            QObject::tr("Only %1 was opened; drop one study at a time.")
                .arg(QFileInfo(path).fileName()));
}

} // namespace ui
