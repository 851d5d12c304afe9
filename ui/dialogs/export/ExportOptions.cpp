// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/ExportOptions.h"

#include "core/session/EditSession.h"
#include "core/session/past/SegmentLayers.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/export/DeidentifyBox.h"
#include "ui/texts/ClauseText.h"
#include "ui/texts/ExportFormatTexts.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <initializer_list>

namespace ui {

namespace {

QLabel* secondaryLine(QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setProperty("role", QStringLiteral("secondary"));
    return label;
}

} // namespace

ExportOptions::ExportOptions(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_format(new QComboBox(this))
    , m_says(secondaryLine(this))
    , m_space(new QComboBox(this))
    , m_spaceName(new QLabel(tr("Axes"), this))
    , m_algorithm(new QComboBox(this))
    , m_algorithmName(new QLabel(tr("Made"), this))
    , m_deflated(new QCheckBox(tr("Compressed (deflated)"), this))
    , m_obstacle(secondaryLine(this))
    , m_deidentify(new DeidentifyBox(this))
{
    m_format->setObjectName(QStringLiteral("exportFormat"));
    m_format->setMaxVisibleItems(int(core::exportFormats().size()));
    m_says->setObjectName(QStringLiteral("exportSays"));
    m_space->setObjectName(QStringLiteral("exportSpace"));
    m_space->addItem(tr("LPS (DICOM, ITK)"));
    m_space->addItem(tr("RAS (NIfTI, 3D Slicer's scene)"));
    m_algorithm->setObjectName(QStringLiteral("exportAlgorithm"));
    m_algorithm->addItem(tr("semiautomatically"), int(core::SegAlgorithm::Semiautomatic));
    m_algorithm->addItem(tr("by hand"), int(core::SegAlgorithm::Manual));
    m_algorithm->addItem(tr("automatically"), int(core::SegAlgorithm::Automatic));
    m_algorithm->setToolTip(tr("What the object says of how its segments were made"));
    m_deflated->setObjectName(QStringLiteral("exportDeflated"));
    m_deflated->setToolTip(
        tr("A smaller file, in a transfer syntax that some programs and archives "
           "refuse"));

    auto* formats = new QHBoxLayout;
    formats->setContentsMargins(0, 0, 0, 0);
    formats->addWidget(new QLabel(tr("Format"), this));
    formats->addWidget(m_format);
    formats->addSpacing(theme::padding);
    formats->addWidget(m_spaceName);
    formats->addWidget(m_space);
    formats->addWidget(m_algorithmName);
    formats->addWidget(m_algorithm);
    formats->addSpacing(theme::padding);
    formats->addWidget(m_deflated);
    formats->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addLayout(formats);
    layout->addWidget(m_says);
    layout->addWidget(m_obstacle);
    layout->addWidget(m_deidentify);

    fillFormats();
    connect(m_format, &QComboBox::currentIndexChanged, this, [this] {
        showFormat();
        Q_EMIT formatChanged();
    });
    for (QComboBox* box : {m_space, m_algorithm})
        connect(box, &QComboBox::currentIndexChanged, this, &ExportOptions::changed);
    connect(m_deflated, &QCheckBox::toggled, this, &ExportOptions::changed);
    connect(m_deidentify, &DeidentifyBox::changed, this, &ExportOptions::changed);
    showFormat();
}

core::ExportFormat ExportOptions::format() const
{
    return core::ExportFormat(m_format->currentData().toInt());
}

void ExportOptions::choose(core::ExportFormat format)
{
    const int row = m_format->findData(int(format));
    const auto* model = qobject_cast<const QStandardItemModel*>(m_format->model());
    if (row >= 0 && (!model || model->item(row)->isEnabled()))
        m_format->setCurrentIndex(row);
}

void ExportOptions::putInto(core::ExportRequest& request) const
{
    request.format = format();
    request.space = m_space->currentIndex() == 0 ? core::MeshSpace::Lps : core::MeshSpace::Ras;
    request.seg.deflated = m_deflated->isChecked();
    request.seg.algorithm = core::SegAlgorithm(m_algorithm->currentData().toInt());
    if (const core::Volume* volume = m_workspace.volume())
        request.deidentifier = m_deidentify->deidentifier(volume->identity);
}

QString ExportOptions::problem() const
{
    return m_deidentify->problem();
}

void ExportOptions::fillFormats()
{
    const core::Volume* volume = m_workspace.volume();
    const QString obstacle = volume ? clauseText(core::dicomSegObstacle(*volume)) : QString();
    auto* model = qobject_cast<QStandardItemModel*>(m_format->model());
    int first = -1;
    for (const core::ExportFormatFacts& facts : core::exportFormats()) {
        m_format->addItem(QStringLiteral("%1 (%2)").arg(
                              exportFormatTitle(facts.format), QLatin1String(facts.ending)),
            int(facts.format));
        const int row = m_format->count() - 1;
        const bool possible = obstacle.isEmpty() || !facts.namesSourceImages;
        if (model)
            model->item(row)->setEnabled(possible);
        first = first < 0 && possible ? row : first;
    }
    m_format->setCurrentIndex(first);
    m_obstacle->setVisible(!obstacle.isEmpty());
    m_obstacle->setText(tr("DICOM objects are not possible: %1").arg(obstacle));
}

void ExportOptions::showFormat()
{
    QString says = exportFormatSays(format());
    const core::EditSession* session = m_workspace.session();
    if (format() == core::ExportFormat::DicomSegFractional && session
        && core::layersOfSegments(session->history(), session->document()).empty())
        says += tr(" No segment here was made of a sculpt layer: every voxel will be 0 or 255.");
    m_says->setText(says);
    m_space->setVisible(facts().isSurface);
    m_spaceName->setVisible(facts().isSurface);
    for (QWidget* option :
        std::initializer_list<QWidget*>{m_algorithm, m_algorithmName, m_deflated})
        option->setVisible(facts().isSeg);
}

} // namespace ui
