// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/CarvedExportDialog.h"

#include "core/export/CarvedVolume.h"
#include "core/sessionfile/SessionStudy.h"
#include "ui/base/TabOrder.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/export/DeidentifyBox.h"
#include "ui/dialogs/export/ExportRun.h"
#include "ui/dialogs/export/SuggestedTarget.h"
#include "ui/dialogs/export/TargetRow.h"
#include "ui/dialogs/study/StudyBlock.h"
#include "ui/texts/ClauseText.h"
#include "ui/texts/ReportTexts.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/widgets/fields/ValueField.h"
#include "ui/workspace/Workspace.h"

#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <set>

namespace ui {

namespace {

QLabel* line(QWidget* parent, const QString& text, const char* role)
{
    auto* label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setProperty("role", QLatin1String(role));
    return label;
}

const core::SculptLayer* activeLayer(Workspace& workspace)
{
    return workspace.session()->document().layer(workspace.activeLayer());
}

/// The greatest coverage of any layer.
std::vector<std::uint8_t> composed(
    const std::vector<ExportJob::Plane>& layers, std::size_t voxelCount)
{
    std::vector<std::uint8_t> carved(voxelCount, 0);
    for (const ExportJob::Plane& layer : layers)
        std::transform(carved.begin(), carved.end(), layer.labels.begin(), carved.begin(),
            [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    return carved;
}

} // namespace

CarvedExportDialog::CarvedExportDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent)
    , m_workspace(workspace)
{
    setWindowTitle(tr("Export carved volume"));
    resize(620, 360);
    build();
    suggestTarget();

    for (QRadioButton* button : {m_series, m_nifti, m_coverage})
        connect(button, &QRadioButton::toggled, this, &CarvedExportDialog::suggestTarget);
    connect(m_target, &TargetRow::changed, this, &CarvedExportDialog::showState);
    connect(m_fill, &QDoubleSpinBox::valueChanged, this, &CarvedExportDialog::showState);
    connect(m_deidentify, &DeidentifyBox::changed, this, &CarvedExportDialog::suggestName);
    connect(m_deidentify, &DeidentifyBox::changed, this, &CarvedExportDialog::showState);
    connect(m_run, &ExportRun::startRequested, this, &CarvedExportDialog::start);
    connect(m_run, &ExportRun::closeRequested, this, &CarvedExportDialog::reject);
    connect(&m_workspace, &Workspace::sessionChanged, this, [this] {
        m_fetch.cancel();
        disconnect(&m_job, nullptr, this, nullptr); // it would tell of a study that is gone
        QDialog::reject();
    });
    connect(&m_fetch, &LabelFetch::progressed, this, [this](int done, int total) {
        m_run->showProgress(tr("Reading what is carved"), done, total);
    });
    connect(&m_fetch, &LabelFetch::finished, this, &CarvedExportDialog::write);
    connect(&m_fetch, &LabelFetch::failed, this, &CarvedExportDialog::showFailure);
    connect(&m_job, &ExportJob::progressed, m_run, &ExportRun::showProgress);
    connect(&m_job, &ExportJob::finished, this, &CarvedExportDialog::showReport);
    connect(&m_job, &ExportJob::failed, this, &CarvedExportDialog::showFailure);
}

void CarvedExportDialog::build()
{
    const core::Volume& volume = *m_workspace.volume();
    const core::SculptLayer* layer = activeLayer(m_workspace);
    m_series = new QRadioButton(
        tr("DICOM: a new series of the same study, in a new folder (sent nowhere)"), this);
    m_series->setObjectName(QStringLiteral("carvedSeries"));
    m_nifti = new QRadioButton(tr("NIfTI volume (.nii.gz, no patient data)"), this);
    m_nifti->setObjectName(QStringLiteral("carvedNifti"));
    m_coverage = new QRadioButton(
        tr("Only the coverage of layer '%1', as NIfTI").arg(layer ? layer->name : QString()), this);
    m_coverage->setObjectName(QStringLiteral("carvedCoverage"));
    m_coverage->setEnabled(layer);
    const QString obstacle = clauseText(core::carvedSeriesObstacle(volume));
    auto* why = line(this, tr("A DICOM series is not possible: %1").arg(obstacle), "secondary");
    why->setVisible(!obstacle.isEmpty());
    m_series->setEnabled(obstacle.isEmpty());
    (obstacle.isEmpty() ? m_series : m_nifti)->setChecked(true);

    m_fillLabel = new QLabel(tr("Where nothing is left"), this);
    m_fill = new NumberField(this);
    m_fill->setObjectName(QStringLiteral("carvedFill"));
    m_fill->setRange(-1e6, 1e6);
    m_fill->setDecimals(volume.encoding.rescaleSlope == 1.0
            ? 0
            : std::max(3, valueFieldDecimals(volume.maximum - volume.minimum)));
    m_fill->setValue(volume.minimum);
    m_least = m_fill->value();
    if (!volume.unit.isEmpty())
        m_fill->setSuffix(QLatin1Char(' ') + volume.unit);
    m_fill->setToolTip(tr("The value of the voxels that are carved away; at first the least of the "
                          "study"));
    m_deidentify = new DeidentifyBox(this);
    m_target = new TargetRow(tr("To"), QStringLiteral("carvedTarget"), exportFolderKey(),
        suggestedFolder(&volume), this);
    auto* startButton = new QPushButton(tr("Export and check"), this);
    startButton->setObjectName(QStringLiteral("carvedStart"));
    m_run = new ExportRun(QStringLiteral("carved"), startButton, this);

    auto* fill = new QHBoxLayout;
    fill->addWidget(m_fillLabel);
    fill->addWidget(m_fill);
    fill->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(theme::padding, theme::padding, theme::padding, theme::padding);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(new StudyBlock(volume, this));
    layout->addWidget(m_series);
    layout->addWidget(why);
    layout->addWidget(m_nifti);
    layout->addWidget(m_coverage);
    layout->addLayout(fill);
    layout->addWidget(m_deidentify);
    layout->addWidget(m_target);
    layout->addWidget(m_run);
    layout->addStretch(1);
    layout->addLayout(m_run->makeButtons());
    tabAsLaidOut(*this);
}

void CarvedExportDialog::suggestTarget()
{
    m_target->setName(nameOfTarget());
    m_suggested = m_target->path();
    m_target->askFor(tr("Export to"),
        m_series->isChecked() ? tr("New folder (*)") : tr("NIfTI (*.nii.gz *.nii)"));
    m_deidentify->setVisible(m_series->isChecked());
    m_fill->setEnabled(!m_coverage->isChecked());
    m_fillLabel->setEnabled(!m_coverage->isChecked());
    showState();
}

QString CarvedExportDialog::nameOfTarget() const
{
    const core::Volume& volume = *m_workspace.volume();
    const bool isSeries = m_series->isChecked();
    const core::SculptLayer* layer = m_coverage->isChecked() ? activeLayer(m_workspace) : nullptr;
    const bool deidentified = isSeries && m_deidentify->deidentifier(volume.identity);
    return exportName(volume.identity, layer ? tr("%1 coverage").arg(layer->name) : tr("carved"),
               !deidentified, pointOf(volume))
        + (isSeries ? QString() : QStringLiteral(".nii.gz"));
}

/// The name follows what is chosen until the user writes another one.
void CarvedExportDialog::suggestName()
{
    if (running() || !m_workspace.volume() || m_target->path() != m_suggested)
        return;
    m_target->setName(nameOfTarget());
    m_suggested = m_target->path();
}

void CarvedExportDialog::showState()
{
    if (running())
        return;
    m_run->expectStart();
    m_run->sayMissing(m_target->path().isEmpty() ? tr("Name the target.")
            : m_series->isChecked()              ? m_deidentify->problem()
                                                 : QString());
}

void CarvedExportDialog::start()
{
    if (!m_workspace.session() || running())
        return;
    const QFileInfo target(m_target->path());
    m_force = false;
    if (!m_series->isChecked() && target.exists()) {
        if (!mayReplace(target.filePath(), this))
            return;
        m_force = true;
    }
    // The question above waits for its answer, and the session may have been closed meanwhile.
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    makeFolderBeside(*m_workspace.volume(), m_target->path());
    m_target->remember();
    std::set<std::uint8_t> layers;
    for (const core::SculptLayer& layer : session->document().layers) {
        const bool wanted = m_coverage->isChecked() ? layer.id == m_workspace.activeLayer()
                                                    : session->document().carves(layer);
        if (wanted)
            layers.insert(layer.id);
    }
    m_run->clearReport();
    m_run->showProgress(tr("Reading what is carved"), 0, 0);
    m_fetch.start(*session, layers, core::Field::Coverage);
    showRunning(true);
}

void CarvedExportDialog::write(const LabelFetch::Planes& layers)
{
    const core::Volume volume = *m_workspace.volume();
    std::vector<std::uint8_t> coverage = composed(*layers, volume.geometry.voxelCount());
    const QString target = m_target->path();
    if (m_coverage->isChecked()) {
        const core::SculptLayer* layer = activeLayer(m_workspace);
        m_job.start([volume, target, force = m_force, name = layer ? layer->name : QString(),
                        bytes = std::move(coverage)](const core::Progress& progress) {
            return core::exportCoverage(volume,
                {.file = target, .force = force, .layer = name, .coverage = bytes}, progress);
        });
        return;
    }
    // Rounded as the field shows it, the least value may be one that no image of the study has.
    const std::optional<double> fill =
        m_fill->value() == m_least ? std::nullopt : std::optional(m_fill->value());
    m_job.start(
        [volume, target, force = m_force, fill,
            deidentifier =
                m_series->isChecked() ? m_deidentify->deidentifier(volume.identity) : nullptr,
            session = m_workspace.session()->file(), bytes = std::move(coverage)](
            const core::Progress& progress) -> core::Result<core::ExportReport> {
            // The engine alone has the values; exactly they are had from where the study lies.
            const auto study = core::loadSessionStudy(
                session, core::SessionSource::of(volume), QString(), QString(), progress);
            if (!study)
                return tl::unexpected(study.error());
            return core::exportCarvedVolume(study->volume,
                {.target = target,
                    .force = force,
                    .coverage = bytes,
                    .codes = study->codes,
                    .fill = fill,
                    .deidentifier = deidentifier},
                progress);
        });
}

void CarvedExportDialog::showRunning(bool isRunning)
{
    const bool possible = core::carvedSeriesObstacle(*m_workspace.volume()).isEmpty();
    for (QWidget* input : std::initializer_list<QWidget*>{m_nifti, m_deidentify, m_target})
        input->setEnabled(!isRunning);
    m_series->setEnabled(!isRunning && possible);
    m_coverage->setEnabled(!isRunning && activeLayer(m_workspace));
    m_fill->setEnabled(!isRunning && !m_coverage->isChecked());
    m_run->setRunning(isRunning);
    if (!isRunning)
        showState();
}

void CarvedExportDialog::showReport(const core::ExportReport& report)
{
    showRunning(false);
    m_run->showReport(reportTexts(report));
    m_workspace.say(tr("Exported and checked: %1").arg(report.file));
    Q_EMIT exported(report.file);
}

void CarvedExportDialog::showFailure(const core::Error& error)
{
    showRunning(false);
    m_run->showFailure(error);
}

void CarvedExportDialog::reject()
{
    if (m_fetch.running()) {
        m_fetch.cancel();
        return showFailure({core::ErrorCode::Cancelled, {}});
    }
    if (m_job.running())
        return m_job.cancel();
    QDialog::reject();
}

} // namespace ui
