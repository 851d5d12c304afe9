// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/ExportDialog.h"

#include "ui/ErrorText.h"
#include "ui/StudyTexts.h"
#include "ui/Theme.h"
#include "ui/Workspace.h"
#include "ui/dialogs/CodeDialog.h"
#include "ui/models/SegmentListModel.h"
#include "ui/pacs/SendDialog.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStandardItemModel>
#include <QStandardPaths>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>
#include <set>

namespace ui {

namespace {

enum Column { NameColumn, VolumeColumn, CodeColumn, RemarkColumn };
constexpr int labelRole = Qt::UserRole;

QString folderKey()
{
    return QStringLiteral("export/folder");
}

QString suffixOf(core::ExportFormat format)
{
    return QLatin1String(core::factsOf(format).ending);
}

/// Numbers at the right, with a gap to the words of the next column.
class NumberDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
        const QModelIndex& index) const override
    {
        QStyleOptionViewItem narrower = option;
        narrower.rect.setRight(option.rect.right() - theme::padding);
        QStyledItemDelegate::paint(painter, narrower, index);
    }
};

QLabel* line(QWidget* parent, const QString& text, const QString& role = {})
{
    auto* label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    if (!role.isEmpty())
        label->setProperty("role", role);
    return label;
}

/// Of a growth; null for other edits.
const std::optional<int>* askedSteps(const core::Edit& edit)
{
    if (const auto* grow = std::get_if<core::GrowSteps>(&edit))
        return &grow->steps;
    const auto* change = std::get_if<core::ChangeInterval>(&edit);
    return change ? &change->steps : nullptr;
}

} // namespace

std::bitset<256> growingLabels(core::EditSession& session)
{
    std::bitset<256> seeded;
    bool grown = false;
    const core::History& history = session.history();
    std::bitset<256> pending;
    for (const core::RowId id : history.standing()) {
        const core::Edit& edit = history.row(id).edit;
        if (const auto* seed = std::get_if<core::SeedStroke>(&edit)) {
            seeded.set(std::size_t(seed->segment));
            pending.set(std::size_t(seed->segment));
        } else if (const auto* paint = std::get_if<core::PaintStroke>(&edit);
                   paint && paint->seeds) {
            seeded.set(std::size_t(paint->segment));
            pending.set(std::size_t(paint->segment));
        } else if (const std::optional<int>* asked = askedSteps(edit)) {
            pending.reset();
            // A row without a number of steps ran to closure; so did one that stopped early.
            const int steps = history.row(id).statistics.generations;
            grown = !*asked || steps < **asked;
        } else if (std::holds_alternative<core::ShrinkSteps>(edit)) {
            grown = false;
        }
    }
    return grown ? pending : seeded;
}

ExportDialog::ExportDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent)
    , m_workspace(workspace)
{
    setWindowTitle(tr("Export segments"));
    resize(720, 640);
    build();
    fillSegments();
    showFormat();

    connect(m_segments, &QTreeWidget::itemChanged, this, [this](const QTreeWidgetItem* item) {
        if (m_filling)
            return;
        const auto label = std::size_t(item->data(NameColumn, labelRole).toInt());
        m_unticked.set(label, item->checkState(NameColumn) != Qt::Checked);
        showState();
    });
    connect(m_segments, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item, int column) {
        if (column == CodeColumn)
            chooseCode(item);
    });
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::showFormat);
    connect(m_file, &QLineEdit::textChanged, this, &ExportDialog::showState);
    connect(m_browse, &QPushButton::clicked, this, &ExportDialog::browse);
    connect(m_export, &QPushButton::clicked, this, &ExportDialog::start);
    connect(m_close, &QPushButton::clicked, this, &ExportDialog::reject);
    connect(
        m_send, &QPushButton::clicked, this, [this] { SendDialog({m_request.file}, this).exec(); });
    connect(&m_workspace, &Workspace::documentChanged, this,
        [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Segments)
                fillSegments();
        });
    connect(&m_workspace, &Workspace::sessionChanged, this, [this] {
        m_fetch.cancel();
        QDialog::reject();
    });
    connect(&m_fetch, &LabelFetch::progressed, this,
        [this](int done, int total) { showProgress(tr("Reading the segments"), done, total); });
    connect(&m_fetch, &LabelFetch::finished, this, &ExportDialog::write);
    connect(&m_fetch, &LabelFetch::failed, this, &ExportDialog::showFailure);
    connect(&m_job, &ExportJob::progressed, this, &ExportDialog::showProgress);
    connect(&m_job, &ExportJob::finished, this, &ExportDialog::showReport);
    connect(&m_job, &ExportJob::failed, this, &ExportDialog::showFailure);
}

void ExportDialog::build()
{
    m_segments = new QTreeWidget(this);
    m_segments->setObjectName(QStringLiteral("exportSegments"));
    m_segments->setHeaderLabels({tr("Segment"), tr("Volume"), tr("Code"), tr("Remarks")});
    m_segments->setRootIsDecorated(false);
    m_segments->setUniformRowHeights(true);
    m_segments->setSelectionMode(QAbstractItemView::NoSelection);
    m_segments->header()->setSectionResizeMode(RemarkColumn, QHeaderView::Stretch);
    m_segments->setItemDelegateForColumn(VolumeColumn, new NumberDelegate(m_segments));
    m_segments->setColumnWidth(NameColumn, 200);
    m_segments->setColumnWidth(VolumeColumn, 90);
    m_segments->setColumnWidth(CodeColumn, 190);
    m_format = new QComboBox(this);
    m_format->setObjectName(QStringLiteral("exportFormat"));
    m_formatSays = line(this, {}, QStringLiteral("secondary"));
    m_space = new QComboBox(this);
    m_space->setObjectName(QStringLiteral("exportSpace"));
    m_spaceName = new QLabel(tr("Axes"), this);
    m_obstacle = line(this, {}, QStringLiteral("secondary"));
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

    auto* formats = new QHBoxLayout;
    formats->addWidget(new QLabel(tr("Format"), this));
    formats->addWidget(m_format);
    formats->addSpacing(theme::padding);
    formats->addWidget(m_spaceName);
    formats->addWidget(m_space);
    formats->addStretch(1);
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
    layout->addLayout(formats);
    layout->addWidget(m_formatSays);
    layout->addWidget(m_obstacle);
    layout->addLayout(target);
    layout->addWidget(m_state);
    layout->addWidget(m_progress);
    layout->addWidget(m_report);
    layout->addLayout(buttons);

    fillFormats();
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString folder = QSettings().value(folderKey(), documents).toString();
    m_file->setText(QDir(folder).filePath(QStringLiteral("segmentation") + suffixOf(format())));
}

void ExportDialog::fillFormats()
{
    const core::Volume* volume = m_workspace.volume();
    const QString obstacle = volume ? core::dicomSegObstacle(*volume) : QString();
    auto* model = qobject_cast<QStandardItemModel*>(m_format->model());
    int first = -1;
    for (const core::ExportFormatFacts& facts : core::exportFormats()) {
        m_format->addItem(
            QStringLiteral("%1 (%2)").arg(QLatin1String(facts.title), QLatin1String(facts.ending)),
            int(facts.format));
        const int row = m_format->count() - 1;
        const bool possible = obstacle.isEmpty() || !facts.namesSourceImages;
        if (model)
            model->item(row)->setEnabled(possible);
        first = first < 0 && possible ? row : first;
    }
    m_format->setCurrentIndex(first);
    m_obstacle->setVisible(!obstacle.isEmpty());
    m_obstacle->setText(tr("DICOM SEG and RTSTRUCT are not possible: %1").arg(obstacle));
    m_space->addItem(tr("LPS (DICOM, ITK)"));
    m_space->addItem(tr("RAS (NIfTI, 3D Slicer's scene)"));
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

void ExportDialog::fillSegments()
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const auto choices = core::exportChoices(session->document(), growingLabels(*session));
    const bool first = m_segments->topLevelItemCount() == 0;
    m_filling = true;
    m_segments->clear();
    for (const core::ExportChoice& choice : choices) {
        const core::Segment& segment = choice.segment;
        if (first)
            m_unticked.set(segment.label, !choice.chosen);
        auto* item = new QTreeWidgetItem(m_segments);
        item->setText(NameColumn, segment.name);
        item->setData(NameColumn, labelRole, int(segment.label));
        QPixmap swatch(12, 12);
        swatch.fill(QColor(segment.rgb));
        item->setIcon(NameColumn, QIcon(swatch));
        item->setCheckState(
            NameColumn, m_unticked.test(segment.label) ? Qt::Unchecked : Qt::Checked);
        item->setText(VolumeColumn,
            millilitreText(segment.voxels, m_workspace.volume()->geometry.voxelVolumeMm3()));
        item->setTextAlignment(VolumeColumn, Qt::AlignRight | Qt::AlignVCenter);
        item->setText(CodeColumn, segment.code.isSet() ? segment.code.meaning : tr("choose …"));
        item->setToolTip(CodeColumn, tr("Click to choose what the segment is"));
        item->setForeground(CodeColumn, segment.code.isSet() ? theme::text : theme::accent);
        item->setText(RemarkColumn, choice.remarks.join(QStringLiteral(", ")));
        item->setForeground(RemarkColumn, theme::caution);
    }
    m_filling = false;
    showState();
}

core::ExportFormat ExportDialog::format() const
{
    return core::ExportFormat(m_format->currentData().toInt());
}

std::vector<core::Segment> ExportDialog::chosen() const
{
    std::vector<core::Segment> segments;
    const core::EditSession* session = m_workspace.session();
    for (int row = 0; session && row < m_segments->topLevelItemCount(); ++row) {
        const QTreeWidgetItem* item = m_segments->topLevelItem(row);
        const auto* segment =
            session->document().segment(item->data(NameColumn, labelRole).toInt());
        if (segment && item->checkState(NameColumn) == Qt::Checked)
            segments.push_back(*segment);
    }
    return segments;
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
    const core::ExportFormatFacts& facts = core::factsOf(format());
    m_formatSays->setText(QLatin1String(facts.says));
    m_space->setVisible(facts.isSurface);
    m_spaceName->setVisible(facts.isSurface);
    m_file->setText(file + suffixOf(format()));
    showState();
}

void ExportDialog::showState()
{
    if (running())
        return;
    const auto segments = chosen();
    const auto uncoded = std::find_if(segments.begin(), segments.end(),
        [](const core::Segment& segment) { return !segment.code.isSet(); });
    QString problem;
    if (segments.empty())
        problem = tr("Tick at least one segment.");
    else if (format() == core::ExportFormat::DicomSeg && uncoded != segments.end())
        problem =
            tr("“%1” is not coded yet: click its code and say what it is.").arg(uncoded->name);
    else if (m_file->text().trimmed().isEmpty())
        problem = tr("Name the file.");
    m_state->setText(problem);
    m_export->setEnabled(problem.isEmpty());
}

void ExportDialog::chooseCode(QTreeWidgetItem* item)
{
    core::EditSession* session = m_workspace.session();
    const int label = item->data(NameColumn, labelRole).toInt();
    const core::Segment* segment = session ? session->document().segment(label) : nullptr;
    if (!segment || running())
        return;
    CodeDialog dialog(segment->name, segment->code, this);
    if (dialog.exec() != QDialog::Accepted || session != m_workspace.session())
        return;
    core::ChangeSegment edit;
    edit.segment = label;
    edit.code = dialog.code();
    if (const auto applied = session->apply(edit); !applied)
        showFailure(applied.error());
}

void ExportDialog::browse()
{
    const core::ExportFormatFacts& facts = core::factsOf(format());
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
    request.format = format();
    request.file = m_file->text().trimmed();
    request.space = m_space->currentIndex() == 0 ? core::MeshSpace::Lps : core::MeshSpace::Ras;
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
    for (const core::Segment& segment : chosen())
        planes.insert(segment.plane);
    m_report->hide();
    m_send->hide();
    showProgress(tr("Reading the segments"), 0, 0);
    // What is exported is what the history holds: a running growth is closed first.
    m_fetch.start(*session, planes);
    showRunning(true);
}

void ExportDialog::write(const std::vector<ExportJob::Plane>& planes)
{
    m_request.segments = chosen();
    m_job.start(*m_workspace.volume(), m_request, planes);
}

void ExportDialog::showRunning(bool isRunning)
{
    for (QWidget* input :
        std::initializer_list<QWidget*>{m_segments, m_format, m_space, m_file, m_browse})
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
    if (m_fetch.running()) {
        m_fetch.cancel();
        return showFailure({core::ErrorCode::Cancelled, {}});
    }
    if (m_job.running())
        return m_job.cancel();
    QDialog::reject();
}

} // namespace ui
