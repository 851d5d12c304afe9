// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/ExportDialog.h"

#include "core/dicom/deidentify/Deidentifier.h"
#include "core/export/common/ImportedSegments.h"
#include "core/export/common/StatisticsText.h"
#include "core/session/EditSession.h"
#include "core/session/past/PastImports.h"
#include "core/session/past/SegmentLayers.h"
#include "core/sessionfile/SessionStudy.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/TabOrder.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/export/ExportOptions.h"
#include "ui/dialogs/export/ExportRun.h"
#include "ui/dialogs/export/ExportSegments.h"
#include "ui/dialogs/export/SuggestedTarget.h"
#include "ui/dialogs/export/TargetRow.h"
#include "ui/dialogs/study/StudyBlock.h"
#include "ui/pacs/SendDialog.h"
#include "ui/texts/ExportFormatTexts.h"
#include "ui/texts/ReportTexts.h"
#include "ui/workspace/Workspace.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>
#include <set>

namespace ui {

namespace {

QString suffixOf(core::ExportFormat format)
{
    return QLatin1String(core::factsOf(format).ending);
}

/// A report comes with the SEG that it refers to, which goes first.
QStringList filesOf(const core::ExportRequest& request)
{
    QStringList files{request.file};
    if (request.format == core::ExportFormat::Sr)
        files.prepend(core::segBeside(request.file));
    return files;
}

} // namespace

ExportDialog::ExportDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent)
    , m_workspace(workspace)
{
    setWindowTitle(tr("Export segments"));
    resize(760, 660);
    build();
    showFormat();

    connect(m_segments, &ExportSegments::changed, this, &ExportDialog::suggestName);
    connect(m_options, &ExportOptions::changed, this, &ExportDialog::suggestName);
    connect(m_segments, &ExportSegments::changed, this, &ExportDialog::showChange);
    connect(m_segments, &ExportSegments::failed, this, &ExportDialog::showFailure);
    connect(m_options, &ExportOptions::formatChanged, this, &ExportDialog::showFormat);
    connect(m_options, &ExportOptions::changed, this, &ExportDialog::showChange);
    connect(m_target, &TargetRow::changed, this, &ExportDialog::showChange);
    connect(m_run, &ExportRun::startRequested, this, &ExportDialog::start);
    connect(m_run, &ExportRun::closeRequested, this, &ExportDialog::reject);
    connect(m_send, &QPushButton::clicked, this,
        [this] { SendDialog(filesOf(m_request), this).exec(); });
    connect(&m_workspace, &Workspace::sessionChanged, this, [this] {
        m_fetch.cancel();
        m_coverageFetch.cancel();
        QDialog::reject();
    });
    connect(&m_fetch, &LabelFetch::progressed, this, [this](int done, int total) {
        m_run->showProgress(tr("Reading the segments"), done, total);
    });
    connect(&m_fetch, &LabelFetch::finished, this, &ExportDialog::takeLabels);
    connect(&m_coverageFetch, &LabelFetch::progressed, this, [this](int done, int total) {
        m_run->showProgress(tr("Reading what is carved"), done, total);
    });
    connect(&m_coverageFetch, &LabelFetch::finished, this, &ExportDialog::write);
    for (const LabelFetch* fetch : {&m_fetch, &m_coverageFetch})
        connect(fetch, &LabelFetch::failed, this, &ExportDialog::showFailure);
    connect(&m_job, &ExportJob::progressed, m_run, &ExportRun::showProgress);
    connect(&m_job, &ExportJob::finished, this, &ExportDialog::showReport);
    connect(&m_job, &ExportJob::failed, this, &ExportDialog::showFailure);
}

void ExportDialog::build()
{
    m_segments = new ExportSegments(m_workspace, this);
    m_options = new ExportOptions(m_workspace, this);
    m_target = new TargetRow(tr("File"), QStringLiteral("exportFile"), exportFolderKey(),
        suggestedFolder(m_workspace.volume()), this);
    auto* startButton = new QPushButton(tr("Export and check"), this);
    startButton->setObjectName(QStringLiteral("exportStart"));
    m_run = new ExportRun(QStringLiteral("export"), startButton, this);
    m_send = new QPushButton(tr("Send …"), this);
    m_send->setObjectName(QStringLiteral("exportSend"));
    m_send->setToolTip(tr("Store the file at a PACS"));
    m_send->hide();
    m_send->setAutoDefault(false);

    auto* ticks = new QHBoxLayout;
    m_ticked = new QLabel(this);
    m_ticked->setProperty("role", QStringLiteral("secondary"));
    m_ticked->setObjectName(QStringLiteral("exportTicked"));
    ticks->addWidget(m_ticked, 1);
    for (const bool all : {true, false}) {
        auto* button = new QPushButton(all ? tr("Tick all") : tr("Tick none"), this);
        button->setObjectName(all ? QStringLiteral("exportAll") : QStringLiteral("exportNone"));
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, [this, all] { m_segments->tickAll(all); });
        ticks->addWidget(button);
        m_tickers.push_back(button);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(theme::padding, theme::padding, theme::padding, theme::padding);
    layout->setSpacing(theme::smallPadding);
    if (const core::Volume* volume = m_workspace.volume())
        layout->addWidget(new StudyBlock(*volume, this));
    layout->addWidget(m_segments, 1);
    layout->addLayout(ticks);
    layout->addWidget(m_options);
    layout->addWidget(m_target);
    layout->addWidget(m_run);
    layout->addLayout(m_run->makeButtons(m_send));
    tabAsLaidOut(*this);

    suggestName();
}

void ExportDialog::choose(core::ExportFormat format)
{
    m_options->choose(format);
}

/// The name follows what is chosen until the user writes another one.
void ExportDialog::suggestName()
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume || running() || m_target->path() != m_suggested)
        return;
    core::ExportRequest request;
    m_options->putInto(request);
    std::vector<core::Segment> segments = m_segments->chosen();
    // By what they are called in the file: their own names may be the patient's.
    if (request.deidentifier) {
        for (core::Segment& segment : segments)
            segment.name = request.deidentifier->segmentName(
                segment.label, segment.name, segment.code.meaning);
    }
    m_target->setName(
        exportName(volume->identity, segments, !request.deidentifier, pointOf(*volume))
        + suffixOf(m_options->format()));
    m_suggested = m_target->path();
}

void ExportDialog::showFormat()
{
    const core::ExportFormatFacts& chosen = m_options->facts();
    m_target->askFor(tr("Export to"),
        QStringLiteral("%1 (*%2 *%3)")
            .arg(exportFormatTitle(chosen.format), QLatin1String(chosen.ending),
                QLatin1String(chosen.otherEnding)));
    QString file = m_target->path();
    const bool suggested = file == m_suggested;
    for (const core::ExportFormatFacts& facts : core::exportFormats()) {
        for (const char* ending : {facts.ending, facts.otherEnding}) {
            if (*ending != '\0' && file.endsWith(QLatin1String(ending)))
                file.chop(qsizetype(qstrlen(ending)));
        }
    }
    m_target->setPath(file + suffixOf(m_options->format()));
    if (suggested)
        m_suggested = m_target->path();
    showChange();
}

/// The verdict is about what was chosen before.
void ExportDialog::showChange()
{
    if (running())
        return;
    m_run->expectStart();
    m_send->hide();
    showState();
}

void ExportDialog::showState()
{
    if (running())
        return;
    const auto segments = m_segments->chosen();
    std::int64_t voxels = 0;
    for (const core::Segment& segment : segments)
        voxels += segment.voxels;
    if (const core::Volume* volume = m_workspace.volume())
        m_ticked->setText(tr("%1 of %2 ticked · %3")
                              .arg(segments.size())
                              .arg(m_segments->topLevelItemCount())
                              .arg(millilitreText(*volume, voxels)));
    QStringList uncoded;
    for (const core::Segment& segment : segments) {
        if (!segment.code.isSet())
            uncoded += segment.name;
    }
    QString problem;
    if (segments.empty())
        problem = tr("Tick at least one segment.");
    else if (m_options->facts().isSeg && uncoded.size() == 1)
        problem = tr("“%1” is not coded yet: click its code and say what it is.").arg(uncoded[0]);
    else if (m_options->facts().isSeg && !uncoded.isEmpty())
        problem = tr("%1 of the segments are not coded yet, “%2” first: click its code and say "
                     "what it is.")
                      .arg(uncoded.size())
                      .arg(uncoded[0]);
    else if (m_target->path().isEmpty())
        problem = tr("Name the file.");
    else
        problem = m_options->problem();
    m_run->sayMissing(problem);
}

void ExportDialog::start()
{
    if (!m_workspace.session() || running())
        return;
    core::ExportRequest request;
    m_options->putInto(request);
    request.seg.codes = m_segments->codes();
    request.file = m_target->path();
    const QStringList files = filesOf(request);
    for (const QString& file : files) {
        if (!QFileInfo::exists(file))
            continue;
        if (!mayReplace(file, this))
            return;
        request.force = true;
    }
    // The question above waits for its answer, and the session may have been closed meanwhile.
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    m_request = std::move(request);
    if (const core::Volume* volume = m_workspace.volume())
        makeFolderBeside(*volume, m_request.file);
    m_target->remember();
    std::set<std::uint8_t> planes;
    for (const core::Segment& segment : m_segments->chosen())
        planes.insert(segment.plane);
    m_run->clearReport();
    m_send->hide();
    m_run->showProgress(tr("Reading the segments"), 0, 0);
    // What is exported is what the history holds: a running growth is closed first.
    m_fetch.start(*session, planes);
    showRunning(true);
}

void ExportDialog::takeLabels(const LabelFetch::Planes& planes)
{
    m_request.segments = m_segments->chosen();
    m_planes = planes;
    m_layers.clear();
    core::EditSession& session = *m_workspace.session();
    std::set<std::uint8_t> wanted;
    if (m_request.format == core::ExportFormat::DicomSegFractional) {
        for (const auto& [label, layer] :
            core::layersOfSegments(session.history(), session.document())) {
            m_layers.push_back(
                {std::uint8_t(label), std::uint8_t(layer), session.document().layer(layer)->name});
            wanted.insert(std::uint8_t(layer));
        }
    }
    if (wanted.empty())
        return write(std::make_shared<const std::vector<ExportJob::Plane>>());
    m_coverageFetch.start(session, wanted, core::Field::Coverage);
}

void ExportDialog::write(const LabelFetch::Planes& coverages)
{
    m_job.start([volume = *m_workspace.volume(), request = m_request, planes = std::move(m_planes),
                    layers = m_layers, coverages, session = m_workspace.session()->file(),
                    segments = m_workspace.session()->document().segments,
                    measurements = m_workspace.session()->document().measurements,
                    imports = core::doneImports(m_workspace.session()->history())](
                    const core::Progress& progress) -> core::Result<core::ExportReport> {
        core::ExportRequest whole = request;
        for (const ExportJob::Plane& plane : *planes)
            whole.planes.push_back({plane.plane, plane.labels});
        for (const MadeOf& made : layers) {
            for (const ExportJob::Plane& coverage : *coverages) {
                if (coverage.plane == made.layer)
                    whole.coverages.push_back({made.label, made.name, coverage.labels});
            }
        }
        if (!core::factsOf(request.format).isStatistics)
            return core::exportMask(volume, whole, progress);
        // The engine alone has the values; exactly they are had from where the study lies.
        const auto study = core::loadSessionStudy(
            session, core::SessionSource::of(volume), QString(), QString(), progress);
        if (!study)
            return tl::unexpected(study.error());
        whole.codes = study->codes;
        whole.measurements = measurements;
        whole.imported = core::importedAs(segments, imports, volume.geometry.voxelCount());
        return core::exportMask(volume, whole, progress);
    });
}

void ExportDialog::showRunning(bool isRunning)
{
    for (QWidget* input : std::initializer_list<QWidget*>{m_segments, m_options, m_target})
        input->setEnabled(!isRunning);
    for (QPushButton* button : m_tickers)
        button->setEnabled(!isRunning);
    m_run->setRunning(isRunning);
    if (!isRunning)
        showState();
}

void ExportDialog::showReport(const core::ExportReport& report)
{
    showRunning(false);
    m_run->showReport(reportTexts(report));
    m_send->setVisible(core::factsOf(m_request.format).namesSourceImages);
    m_workspace.say(tr("Exported and checked: %1").arg(report.file));
    Q_EMIT exported(report.file);
}

void ExportDialog::showFailure(const core::Error& error)
{
    showRunning(false);
    m_run->showFailure(error);
}

void ExportDialog::reject()
{
    if (m_fetch.running() || m_coverageFetch.running()) {
        m_fetch.cancel();
        m_coverageFetch.cancel();
        return showFailure({core::ErrorCode::Cancelled, {}});
    }
    if (m_job.running())
        return m_job.cancel();
    QDialog::reject();
}

} // namespace ui
