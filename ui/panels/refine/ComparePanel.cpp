// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/refine/ComparePanel.h"

#include "core/measure/MeasuredSize.h"
#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/panels/refine/LookFirstSection.h"
#include "ui/tasks/MaskImporter.h"

#include <QComboBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace ui {

namespace {

QLabel* smallLabel(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setFont(theme::smallFont());
    return label;
}

} // namespace

ComparePanel::ComparePanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_comparison(workspace)
    , m_lookFirst(new LookFirstSection(
          workspace, [this] { return m_comparison.secondMask(); }, this))
    , m_reference(new QComboBox(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(theme::padding, theme::smallPadding, theme::padding, theme::padding);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_lookFirst);
    auto* row = new QHBoxLayout;
    row->setSpacing(theme::smallPadding);
    m_open = new QPushButton(tr("Reference …"), this);
    m_open->setObjectName(QStringLiteral("compareOpen"));
    m_open->setToolTip(tr("A mask's file that is held for the truth; nothing of it is taken into "
                          "the session"));
    m_reference->setObjectName(QStringLiteral("compareReference"));
    m_reference->setAccessibleName(tr("Reference"));
    m_reference->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_imported = new QPushButton(tr("As imported"), this);
    m_imported->setObjectName(QStringLiteral("compareImported"));
    m_imported->setToolTip(
        tr("The masks as this session has imported them: what you have added and "
           "taken since"));
    row->addWidget(m_open);
    row->addWidget(m_imported);
    row->addStretch(1);
    layout->addLayout(row);
    layout->addWidget(m_reference);
    m_what = smallLabel({}, this);
    m_what->setObjectName(QStringLiteral("compareWhat"));
    m_what->setProperty("role", QStringLiteral("secondary"));
    m_what->setWordWrap(true);
    layout->addWidget(m_what);
    m_figures = new QWidget(this);
    auto* grid = new QGridLayout(m_figures);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    struct Row {
        const char* name;
        QString text;
        QString tip;
    };
    const std::array<Row, 6> rows{
        Row{"compareAdded", tr("Added"), tr("What the reference does not have")},
        Row{"compareTaken", tr("Taken"), tr("What only the reference has")},
        Row{"compareError", tr("Volume error"),
            tr("Voxels in which both differ, in percent of the reference's (rVE)")},
        Row{"compareDice", tr("Dice"), tr("Twice the voxels that both have, by the sum of both")},
        Row{"compareHd95", tr("95 % within"),
            tr("So far 95 % of either surface are from the other one at most (HD95)")},
        Row{"compareMean", tr("Mean distance"), tr("Of both surfaces from one another")}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        QLabel* name = smallLabel(rows[i].text, m_figures);
        name->setToolTip(rows[i].tip);
        m_values[i] = smallLabel({}, m_figures);
        m_values[i]->setObjectName(QLatin1String(rows[i].name));
        m_values[i]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grid->addWidget(name, int(i), 0);
        grid->addWidget(m_values[i], int(i), 1);
    }
    layout->addWidget(m_figures);

    connect(m_open, &QPushButton::clicked, this, &ComparePanel::ask);
    connect(m_imported, &QPushButton::clicked, &m_comparison, &LiveComparison::takeImported);
    connect(m_reference, &QComboBox::activated, &m_comparison, &LiveComparison::choose);
    connect(&m_comparison, &LiveComparison::changed, this, &ComparePanel::show);
    connect(&m_comparison, &LiveComparison::failed, &workspace, &Workspace::fail);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &ComparePanel::show);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History)
                allow();
            // The reference's segments have the names of today.
            if (change.what == core::DocumentChange::What::Segments
                && m_comparison.references() != m_references)
                show();
        });
    show();
}

QString ComparePanel::title() const
{
    return tr("Comparison");
}

QString ComparePanel::summary() const
{
    const auto& outcome = m_comparison.outcome();
    return outcome ? tr("Dice %1").arg(numberText(outcome->comparison.dice, 3)) : QString();
}

void ComparePanel::ask()
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("A mask to compare with"), QString(), maskFilter());
    if (!path.isEmpty())
        m_comparison.read(path);
}

QString ComparePanel::whatIsCompared() const
{
    const core::EditSession* session = m_workspace.session();
    const auto& outcome = m_comparison.outcome();
    if (m_comparison.isReading())
        return tr("Reading …");
    const bool hasImported = m_comparison.isImported() && !m_comparison.references().isEmpty();
    if (m_comparison.chosen() < 0 && hasImported)
        return tr("No mask was imported as this segment; choose one in the list.");
    if (m_comparison.chosen() < 0)
        return m_comparison.canTakeImported()
            ? tr("Choose a mask that is held for the truth, or compare with what was imported.")
            : tr("Choose a mask that is held for the truth.");
    const core::Segment* segment =
        session && outcome ? session->document().segment(outcome->segment) : nullptr;
    if (!segment)
        return m_comparison.isBehind() ? tr("Comparing …") : tr("Choose a segment in the list.");
    const QString what =
        outcome->ofSurface ? tr("Surface of %1").arg(segment->name) : segment->name;
    return m_comparison.isBehind() ? tr("%1 …").arg(what) : what;
}

void ComparePanel::allow()
{
    m_open->setEnabled(m_workspace.volume() && !m_comparison.isReading());
    m_imported->setEnabled(!m_comparison.isReading() && m_comparison.canTakeImported());
}

void ComparePanel::show()
{
    const QSignalBlocker blocker(m_reference);
    m_reference->clear();
    m_references = m_comparison.references();
    m_reference->addItems(m_references);
    m_reference->setCurrentIndex(m_comparison.chosen());
    m_reference->setEnabled(m_reference->count() > 1);
    m_reference->setVisible(m_reference->count() > 0);
    m_figures->setVisible(m_comparison.chosen() >= 0);
    m_reference->setToolTip(m_comparison.path());
    allow();
    m_what->setText(whatIsCompared());
    for (QLabel* value : m_values)
        value->setText(QStringLiteral("–"));
    if (const auto& outcome = m_comparison.outcome()) {
        const core::MaskComparison& comparison = outcome->comparison;
        // That nothing was added is a figure, too, and not the dash of one that is not known.
        const auto sizeOf = [volume = m_workspace.volume()](std::uint64_t voxels) {
            return voxels == 0 ? volumeText(*volume, 0)
                               : millilitreText(*volume, std::int64_t(voxels));
        };
        m_values[0]->setText(sizeOf(comparison.voxels - comparison.sharedVoxels));
        m_values[1]->setText(sizeOf(comparison.referenceVoxels - comparison.sharedVoxels));
        if (comparison.relativeVolumeError)
            m_values[2]->setText(
                tr("%1 %").arg(numberText(100.0 * *comparison.relativeVolumeError, 2)));
        m_values[3]->setText(numberText(comparison.dice, 4));
        // Where the spacing is unknown, nobody has measured millimetres.
        const bool isMeasured =
            core::unknownSpacing(*m_workspace.volume()) == core::UnknownSpacing::Nothing;
        if (comparison.distances && isMeasured) {
            m_values[4]->setText(
                tr("%1 mm").arg(numberText(comparison.distances->hausdorff95Mm, 2)));
            m_values[5]->setText(tr("%1 mm").arg(numberText(comparison.distances->meanMm, 2)));
        }
    }
    Q_EMIT summaryChanged(summary());
}

} // namespace ui
