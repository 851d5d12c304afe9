// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/MaskImporter.h"

#include "core/dicom/base/DicomFile.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/masks/ReadImport.h"
#include "core/meshfile/MeshReader.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/RowTitleText.h"
#include "ui/texts/MaskTexts.h"
#include "ui/workspace/Workspace.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>

#include <algorithm>
#include <memory>
#include <utility>

namespace ui {

namespace {

/// What is said of an import: what its file brought, and what becomes of overlaps.
QStringList sentencesOn(const core::ReadImport& read, const core::VolumeGeometry& geometry)
{
    constexpr std::size_t mostPairs = 3;
    QStringList sentences;
    for (const core::MaskNote& note : read.notes)
        sentences += maskNoteText(note);
    const std::vector<core::MaskNote> pairs =
        core::notesOnOverlaps(read.overlaps, read.edit, geometry);
    for (std::size_t i = 0; i < std::min(pairs.size(), mostPairs); ++i)
        sentences += maskNoteText(pairs[i]);
    if (pairs.size() > mostPairs)
        sentences += MaskImporter::tr("There are %1 such pairs in all.").arg(pairs.size());
    return sentences;
}

bool isDicomMask(const QString& path)
{
    const core::Result<core::DicomFile> file = core::DicomFile::open(path);
    return file && core::isMaskClass(file->mediaSopClassUid());
}

/// Whether a folder has files of masks. DICOM files may as well be slices; of those the first one
/// tells.
bool holdsMasks(const QString& folder)
{
    const QStringList files = core::maskFilesIn(folder);
    const auto isDicom = [](const QString& file) {
        return file.endsWith(QLatin1String(".dcm"), Qt::CaseInsensitive);
    };
    const auto dicom = std::find_if(files.begin(), files.end(), isDicom);
    return !std::all_of(files.begin(), files.end(), isDicom)
        || (dicom != files.end() && isDicomMask(*dicom));
}

} // namespace

struct MaskImporter::Waiting {
    core::ReadImport read;
    QString path;
};

QString maskFilter()
{
    return QObject::tr("Masks (%1);;All files (*)")
        .arg(core::maskNamePatterns().join(QLatin1Char(' ')));
}

MaskImporter::MaskImporter(Workspace& workspace, QWidget* window)
    : QObject(window)
    , m_workspace(workspace)
    , m_window(window)
{
    // What is read for one study is nothing to the next.
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_background.cancel();
        if (std::exchange(m_waiting, nullptr))
            Q_EMIT noLongerAsked();
    });
}

MaskImporter::~MaskImporter() = default;

bool MaskImporter::looksLikeMask(const QString& path)
{
    const QString name = QFileInfo(QDir::cleanPath(path)).fileName().toLower();
    if (name.endsWith(QLatin1String(".seg.nrrd")) || core::isMeshName(path))
        return true;
    const bool said = name.contains(QLatin1String("label")) || name.contains(QLatin1String("mask"))
        || name.contains(QLatin1String("seg"));
    if (QFileInfo(path).isDir())
        return said && holdsMasks(path);
    const QStringList patterns = core::maskNamePatterns();
    const bool known = std::any_of(patterns.begin(), patterns.end(), [&](const QString& pattern) {
        return pattern != QLatin1String("*.dcm") && name.endsWith(pattern.mid(1));
    });
    if (known)
        return said;
    if (!QFileInfo(path).isFile())
        return false;
    return isDicomMask(path);
}

void MaskImporter::ask()
{
    const QString path =
        QFileDialog::getOpenFileName(m_window, tr("Import a mask"), QString(), maskFilter());
    if (!path.isEmpty())
        import(path);
}

void MaskImporter::askForFolder()
{
    const QString path =
        QFileDialog::getExistingDirectory(m_window, tr("Import the masks of a folder"));
    if (!path.isEmpty())
        import(path);
}

void MaskImporter::import(const QString& path)
{
    read(path, false);
}

void MaskImporter::importDropped(const QString& path)
{
    read(path, true);
}

void MaskImporter::read(const QString& path, bool mayBeImage)
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
        [this, path, mayBeImage](const core::Result<core::ReadImport>& read) {
            if (!read && mayBeImage && core::saysImage(read.error()))
                Q_EMIT isImage(path);
            else
                take(read, path);
        });
}

void MaskImporter::take(const core::Result<core::ReadImport>& read, const QString& path)
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    if (!read) {
        Q_EMIT failed(read.error());
        return;
    }
    if (read->overlaps.empty())
        return apply(*read, path);
    m_waiting = std::make_unique<Waiting>(Waiting{.read = *read, .path = path});
    Q_EMIT overlapping(*read, session->document().volumes.front().geometry);
}

void MaskImporter::import(
    const std::optional<std::vector<int>>& ahead, const std::optional<std::vector<int>>& planes)
{
    const std::unique_ptr<Waiting> waiting = std::exchange(m_waiting, nullptr);
    if (!waiting)
        return;
    waiting->read.edit.ahead = ahead;
    waiting->read.edit.planes = planes;
    apply(waiting->read, waiting->path);
}

void MaskImporter::giveUp()
{
    m_waiting.reset();
}

void MaskImporter::apply(const core::ReadImport& read, const QString& path)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    session->closeOpen();
    const std::size_t rows = session->history().rows().size();
    if (const core::Result<void> applied = session->apply(read.edit); !applied) {
        Q_EMIT failed(applied.error());
        return;
    }
    // Answered behind the edit: only then is it known whether any voxel was free.
    session->questions().afterAll(
        [guard = QPointer(this), session, rows, path,
            sentences = sentencesOn(read, session->document().volumes.front().geometry)] {
            if (!guard)
                return;
            if (session->history().rows().size() == rows)
                return Q_EMIT guard->nothingTaken(path);
            guard->showInVolume();
            Q_EMIT guard->imported(nameOf(session->history().rows().back()), sentences);
        });
}

void MaskImporter::showInVolume()
{
    Workspace::VolumeDisplay display = m_workspace.volumeDisplay();
    if (display.context != gpu::Context::Opaque)
        return;
    display.context = gpu::Context::Translucent;
    m_workspace.setVolumeDisplay(display);
}

} // namespace ui
