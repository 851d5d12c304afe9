// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/ExportDialog.h"

#include "core/session/EditSession.h"
#include "core/session/SegmentLayers.h"
#include "core/session/SessionStudy.h"
#include "ui/ErrorText.h"
#include "ui/StudyTexts.h"
#include "ui/Theme.h"
#include "ui/Workspace.h"
#include "ui/dialogs/ExportOptions.h"
#include "ui/dialogs/ExportSegments.h"
#include "ui/pacs/SendDialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>
#include <set>

namespace ui {

namespace {

QString folderKey()
{
    return QStringLiteral("export/folder");
}

QString suffixOf(core::ExportFormat format)
{
    return QLatin1String(core::factsOf(format).ending);
}

QLabel* line(QWidget* parent, const QString& text, const QString& role = {})
{
    auto* label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    if (!role.isEmpty())
        label->setProperty("role", role);
    return label;
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

    connect(m_segments, &ExportSegments::changed, this, &ExportDialog::showState);
    connect(m_segments, &ExportSegments::failed, this, &ExportDialog::showFailure);
    connect(m_options, &ExportOptions::formatChanged, this, &ExportDialog::showFormat);
    connect(m_file, &QLineEdit::textChanged, this, &ExportDialog::showState);
    connect(m_browse, &QPushButton::clicked, this, &ExportDialog::browse);
    connect(m_export, &QPushButton::clicked, this, &ExportDialog::start);
    connect(m_close, &QPushButton::clicked, this, &ExportDialog::reject);
    connect(
        m_send, &QPushButton::clicked, this, [this] { SendDialog({m_request.file}, this).exec(); });
    connect(&m_workspace, &Workspace::sessionChanged, this, [this] {
        m_fetch.cancel();
        m_coverageFetch.cancel();
        QDialog::reject();
    });
    connect(&m_fetch, &LabelFetch::progressed, this,
        [this](int done, int total) { showProgress(tr("Reading the segments"), done, total); });
    connect(&m_fetch, &LabelFetch::finished, this, &ExportDialog::takeLabels);
    connect(&m_coverageFetch, &LabelFetch::progressed, this,
        [this](int done, int total) { showProgress(tr("Reading what is carved"), done, total); });
    connect(&m_coverageFetch, &LabelFetch::finished, this, &ExportDialog::write);
    for (const LabelFetch* fetch : {&m_fetch, &m_coverageFetch})
        connect(fetch, &LabelFetch::failed, this, &ExportDialog::showFailure);
    connect(&m_job, &ExportJob::progressed, this, &ExportDialog::showProgress);
    connect(&m_job, &ExportJob::finished, this, &ExportDialog::showReport);
    connect(&m_job, &ExportJob::failed, this, &ExportDialog::showFailure);
}

void ExportDialog::build()
{
    m_segments = new ExportSegments(m_workspace, this);
    m_options = new ExportOptions(m_workspace, this);
    m_file = new QLineEdit(this);
    m_file->setObjectName(QStringLiteral("exportFile"));
    m_browse = new QPushButton(tr("Browse …"), this);
    m_state = line(this, {}, QStringLiteral("secondary"));
    m_state->setObjectName(QStringLiteral("exportState"));
    m_progress = new QProgressBar(this);
    m_progress->setTextVisible(false);
    m_progress->hide();
    m_report = line(this, {}, QStringLiteral("good"));
    m_report->setObjectName(QStringLiteral("exportReport"));
    m_report->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_report->hide();
    m_export = new QPushButton(tr("Export and check"), this);
    m_export->setObjectName(QStringLiteral("exportStart"));
    m_export->setDefault(true);
    m_close = new QPushButton(tr("Close"), this);
    m_send = new QPushButton(tr("Send …"), this);
    m_send->setObjectName(QStringLiteral("exportSend"));
    m_send->setToolTip(tr("Store the file at a PACS"));
    m_send->hide();
    m_send->setAutoDefault(false);
    m_close->setAutoDefault(false);
    m_browse->setAutoDefault(false);

    auto* target = new QHBoxLayout;
    target->addWidget(new QLabel(tr("File"), this));
    target->addWidget(m_file, 1);
    target->addWidget(m_browse);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_close);
    buttons->addWidget(m_send);
    buttons->addWidget(m_export);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(theme::padding, theme::padding, theme::padding, theme::padding);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(identityBlock());
    layout->addWidget(m_segments, 1);
    layout->addWidget(m_options);
    layout->addLayout(target);
    layout->addWidget(m_state);
    layout->addWidget(m_progress);
    layout->addWidget(m_report);
    layout->addLayout(buttons);

    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString folder = QSettings().value(folderKey(), documents).toString();
    m_file->setText(
        QDir(folder).filePath(QStringLiteral("segmentation") + suffixOf(m_options->format())));
}

QWidget* ExportDialog::identityBlock()
{
    auto* block = new QFrame(this);
    block->setProperty("role", QStringLiteral("bar"));
    auto* layout = new QVBoxLayout(block);
    layout->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    layout->setSpacing(4);
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return block;
    auto* patient = line(block, patientText(volume->identity), QStringLiteral("heading"));
    patient->setObjectName(QStringLiteral("exportPatient"));
    layout->addWidget(patient);
    QStringList study{studyText(volume->identity), seriesText(volume->identity)};
    study.removeAll(QString());
    layout->addWidget(line(block, study.join(QStringLiteral(" · ")), QStringLiteral("secondary")));
    for (const core::VolumeProblem& problem : volume->problems) {
        if (problem.caution)
            layout->addWidget(
                line(block, tr("Caution: %1").arg(problem.text), QStringLiteral("caution")));
    }
    return block;
}

void ExportDialog::showFormat()
{
    QString file = m_file->text();
    for (const core::ExportFormatFacts& facts : core::exportFormats()) {
        for (const char* ending : {facts.ending, facts.otherEnding}) {
            if (*ending != '\0' && file.endsWith(QLatin1String(ending)))
                file.chop(qsizetype(qstrlen(ending)));
        }
    }
    m_file->setText(file + suffixOf(m_options->format()));
    showState();
}

void ExportDialog::showState()
{
    if (running())
        return;
    const auto segments = m_segments->chosen();
    const auto uncoded = std::find_if(segments.begin(), segments.end(),
        [](const core::Segment& segment) { return !segment.code.isSet(); });
    QString problem;
    if (segments.empty())
        problem = tr("Tick at least one segment.");
    else if (m_options->facts().isSeg && uncoded != segments.end())
        problem =
            tr("“%1” is not coded yet: click its code and say what it is.").arg(uncoded->name);
    else if (m_file->text().trimmed().isEmpty())
        problem = tr("Name the file.");
    m_state->setText(problem);
    m_export->setEnabled(problem.isEmpty());
}

void ExportDialog::browse()
{
    const core::ExportFormatFacts& facts = m_options->facts();
    const QString filter = QStringLiteral("%1 (*%2 *%3)")
                               .arg(QLatin1String(facts.title), QLatin1String(facts.ending),
                                   QLatin1String(facts.otherEnding));
    const QString file = QFileDialog::getSaveFileName(
        this, tr("Export to"), m_file->text(), filter, nullptr, QFileDialog::DontConfirmOverwrite);
    if (!file.isEmpty())
        m_file->setText(file);
}

void ExportDialog::start()
{
    core::EditSession* session = m_workspace.session();
    if (!session || running())
        return;
    core::ExportRequest request;
    m_options->putInto(request);
    request.seg.codes = m_segments->codes();
    request.file = m_file->text().trimmed();
    if (QFileInfo::exists(request.file)) {
        const auto answer = QMessageBox::question(this, tr("Replace the file?"),
            tr("%1 exists already. Replace it?").arg(request.file),
            QMessageBox::Yes | QMessageBox::No, QMessageBox::No);
        if (answer != QMessageBox::Yes)
            return;
        request.force = true;
    }
    m_request = std::move(request);
    QSettings().setValue(folderKey(), QFileInfo(m_request.file).absolutePath());
    std::set<std::uint8_t> planes;
    for (const core::Segment& segment : m_segments->chosen())
        planes.insert(segment.plane);
    m_report->hide();
    m_send->hide();
    showProgress(tr("Reading the segments"), 0, 0);
    // What is exported is what the history holds: a running growth is closed first.
    m_fetch.start(*session, planes);
    showRunning(true);
}

void ExportDialog::takeLabels(const std::vector<ExportJob::Plane>& planes)
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
        return write({});
    m_coverageFetch.start(session, wanted, core::Field::Coverage);
}

void ExportDialog::write(const std::vector<ExportJob::Plane>& coverages)
{
    m_job.start([volume = *m_workspace.volume(), request = m_request, planes = std::move(m_planes),
                    layers = m_layers, coverages, session = m_workspace.session()->file()](
                    const core::Progress& progress) -> core::Result<core::ExportReport> {
        core::ExportRequest whole = request;
        for (const ExportJob::Plane& plane : planes)
            whole.planes.push_back({plane.plane, plane.labels});
        for (const MadeOf& made : layers) {
            for (const ExportJob::Plane& coverage : coverages) {
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
        return core::exportMask(volume, whole, progress);
    });
}

void ExportDialog::showRunning(bool isRunning)
{
    for (QWidget* input : std::initializer_list<QWidget*>{m_segments, m_options, m_file, m_browse})
        input->setEnabled(!isRunning);
    m_progress->setVisible(isRunning);
    m_close->setText(isRunning ? tr("Abort") : tr("Close"));
    if (isRunning)
        m_export->setEnabled(false);
    else
        showState();
}

void ExportDialog::showProgress(const QString& step, int done, int total)
{
    m_progress->setRange(0, std::max(total, 0));
    m_progress->setValue(done);
    m_state->setText(step);
}

void ExportDialog::showReport(const core::ExportReport& report)
{
    showRunning(false);
    QStringList lines;
    lines += report.written;
    for (const QString& sentence : report.checked)
        lines += QStringLiteral("✓ ") + sentence;
    lines += tr("SHA-256 of the file: %1").arg(report.sha256);
    for (const QString& caution : report.cautions)
        lines += tr("Caution: %1").arg(caution);
    m_report->setText(lines.join(QLatin1Char('\n')));
    m_report->show();
    m_send->setVisible(core::factsOf(m_request.format).namesSourceImages);
    m_workspace.say(tr("Exported and checked: %1").arg(report.file));
    Q_EMIT exported(report.file);
}

void ExportDialog::showFailure(const core::Error& error)
{
    showRunning(false);
    m_state->setText(error.code == core::ErrorCode::Cancelled
            ? tr("The export was aborted; nothing was written.")
            : errorText(error));
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
