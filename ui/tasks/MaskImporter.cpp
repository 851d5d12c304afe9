// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/MaskImporter.h"

#include "core/dicom/base/DicomFile.h"
#include "core/edits/kinds/segments/ImportMask.h"
#include "core/masks/ReadImport.h"
#include "core/meshfile/MeshReader.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/RowTitleText.h"
#include "ui/texts/MaskTexts.h"
#include "ui/workspace/Workspace.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>

#include <algorithm>
#include <utility>

namespace ui {

QString maskFilter()
{
    return QStringLiteral("Masks (%1);;All files (*)")
        .arg(core::maskNamePatterns().join(QLatin1Char(' ')));
}

MaskImporter::MaskImporter(Workspace& workspace, QWidget* window)
    : QObject(window)
    , m_workspace(workspace)
    , m_window(window)
{
    // What is read for one study is nothing to the next.
    connect(&workspace, &Workspace::sessionChanged, this, [this] { m_background.cancel(); });
}

bool MaskImporter::looksLikeMask(const QString& path)
{
    const QString name = QFileInfo(path).fileName().toLower();
    if (name.endsWith(QLatin1String(".seg.nrrd")) || core::isMeshName(path))
        return true;
    const bool said = name.contains(QLatin1String("label")) || name.contains(QLatin1String("mask"))
        || name.contains(QLatin1String("seg"));
    const QStringList patterns = core::maskNamePatterns();
    const bool known = std::any_of(patterns.begin(), patterns.end(), [&](const QString& pattern) {
        return pattern != QLatin1String("*.dcm") && name.endsWith(pattern.mid(1));
    });
    if (known)
        return said;
    if (!QFileInfo(path).isFile())
        return false;
    const core::Result<core::DicomFile> file = core::DicomFile::open(path);
    return file && core::isMaskClass(file->mediaSopClassUid());
}

void MaskImporter::ask()
{
    const QString path =
        QFileDialog::getOpenFileName(m_window, tr("Import a mask"), QString(), maskFilter());
    if (!path.isEmpty())
        import(path);
}

void MaskImporter::import(const QString& path)
{
    core::EditSession* session = m_workspace.session();
    if (!session || busy())
        return;
    Q_EMIT started(path);
    const core::Document document = session->foreseenDocument();
    m_background.start(
        this,
        [path, volume = document.volumes.front(), before = document.segments.size()](
            const core::Progress& progress) {
            return core::readImport(core::ImportMask{.file = path}, volume, before, progress);
        },
        [this, path](const core::Result<core::ReadImport>& read) { apply(read, path); });
}

void MaskImporter::apply(const core::Result<core::ReadImport>& read, const QString& path)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    if (!read) {
        Q_EMIT failed(read.error());
        return;
    }
    session->closeGrowth();
    const std::size_t rows = session->history().rows().size();
    if (const core::Result<void> applied = session->apply(read->edit); !applied) {
        Q_EMIT failed(applied.error());
        return;
    }
    // Answered behind the edit: only then is it known whether any voxel was free.
    session->questions().afterAll(
        [guard = QPointer(this), session, rows, path, notes = read->notes] {
            if (!guard)
                return;
            if (session->history().rows().size() == rows)
                return Q_EMIT guard->nothingTaken(path);
            QStringList sentences;
            for (const core::MaskNote& note : notes)
                sentences += maskNoteText(note);
            Q_EMIT guard->imported(nameOf(session->history().rows().back()), sentences);
        });
}

} // namespace ui
