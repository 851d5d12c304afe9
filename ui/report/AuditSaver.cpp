// SPDX-License-Identifier: Apache-2.0
#include "ui/report/AuditSaver.h"

#include "core/base/OnMainThread.h"
#include "core/export/common/ImportedSegments.h"
#include "core/session/SessionStorage.h"
#include "core/session/past/PastImports.h"
#include "core/sessionfile/SessionStudy.h"
#include "ui/dialogs/export/SuggestedTarget.h"
#include "ui/report/AuditSegments.h"
#include "ui/report/WriteAudit.h"
#include "ui/workspace/Workspace.h"

namespace ui {

/// What the thread needs to measure the segments.
struct AuditSaver::Measured {
    QString session; ///< its file
    core::Volume volume;
    std::vector<core::Segment> segments;
    std::vector<core::DoneImport> imports;
    core::RowId position = 0;
    LabelFetch::Planes planes; ///< null: there is nothing to measure

    [[nodiscard]] core::Result<AuditSegments> found(const core::Progress& progress) const;
    [[nodiscard]] AuditSegments orNone(const core::Progress& progress) const;
};

core::Result<AuditSegments> AuditSaver::Measured::found(const core::Progress& progress) const
{
    // The engine alone has the values; exactly they are had from where the study lies.
    const auto study = core::loadSessionStudy(
        session, core::SessionSource::of(volume), QString(), QString(), progress);
    if (!study)
        return tl::unexpected(study.error());
    core::ExportRequest request;
    request.segments = segments;
    for (const ExportJob::Plane& plane : *planes)
        request.planes.push_back({plane.plane, plane.labels});
    request.codes = study->codes;
    request.imported = core::importedAs(segments, imports, volume.geometry.voxelCount());
    return auditSegments(volume, request, progress);
}

/// The report is about the session's file, and stands without the study.
AuditSegments AuditSaver::Measured::orNone(const core::Progress& progress) const
{
    core::Result<AuditSegments> measured = found(progress);
    AuditSegments all = measured ? std::move(*measured) : AuditSegments{};
    all.areUnknown = !measured;
    all.position = position;
    return all;
}

AuditSaver::AuditSaver(Workspace& workspace, QWidget* window)
    : QObject(window)
    , m_workspace(workspace)
    , m_window(window)
{
    connect(&m_fetch, &LabelFetch::finished, this, &AuditSaver::audit);
    connect(&m_fetch, &LabelFetch::failed, this, &AuditSaver::fail);
    connect(&workspace, &Workspace::sessionClosing, this, [this] {
        if (m_fetch.running()) {
            m_fetch.cancel();
            m_busy = false;
        }
    });
}

void AuditSaver::ask()
{
    const auto chosen = askForTarget({.title = tr("Audit report"),
                                         .of = tr("audit"),
                                         .ending = QStringLiteral(".pdf"),
                                         .filter = tr("Report to print (*.pdf);;Page for a browser "
                                                      "(*.html)")},
        m_workspace.volume(), m_window);
    if (chosen)
        save(chosen->file);
}

void AuditSaver::save(const QString& path)
{
    core::EditSession* session = m_workspace.session();
    if (!session || m_busy)
        return;
    if (const QString problem = auditNameProblem(path); !problem.isEmpty()) {
        Q_EMIT failed({core::ErrorCode::FileUnwritable, {path, problem}});
        return;
    }
    m_busy = true;
    m_path = path;
    session->closeOpen();
    std::set<std::uint8_t> used;
    for (const core::Segment& segment : session->document().segments)
        used.insert(segment.plane);
    if (used.empty())
        return audit(nullptr);
    m_fetch.start(*session, used);
}

void AuditSaver::fail(const core::Error& error)
{
    m_busy = false;
    Q_EMIT failed(error);
}

void AuditSaver::audit(const LabelFetch::Planes& planes)
{
    core::EditSession& session = *m_workspace.session();
    const Measured measured{.session = session.file(),
        .volume = *m_workspace.volume(),
        .segments = session.document().segments,
        .imports = core::doneImports(session.history()),
        .position = session.history().position(),
        .planes = planes};
    session.storage().audit(
        core::onMainThread(this, [this, measured](const core::Result<core::AuditReport>& report) {
            if (report)
                write(*report, measured);
            else
                fail(report.error());
        }));
}

void AuditSaver::write(const core::AuditReport& report, Measured measured)
{
    m_background.start(
        this,
        [report, path = m_path, measured = std::move(measured)](const core::Progress& progress) {
            if (!measured.planes)
                return writeAudit(report, path, true);
            const AuditSegments segments = measured.orNone(progress);
            return writeAudit(report, path, true, &segments);
        },
        [this, path = m_path](const core::Result<void>& written) {
            m_busy = false;
            if (written)
                Q_EMIT saved(path);
            else
                Q_EMIT failed(written.error());
        });
}

} // namespace ui
