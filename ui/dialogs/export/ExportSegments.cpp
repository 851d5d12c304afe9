// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/ExportSegments.h"

#include "core/edits/kinds/GrowthKinds.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/session/EditSession.h"
#include "core/session/past/SeedStrokes.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/CodeDialog.h"
#include "ui/texts/ExportTexts.h"
#include "ui/workspace/Workspace.h"

#include <QHeaderView>
#include <QPixmap>
#include <QStyledItemDelegate>

#include <algorithm>

namespace ui {

namespace {

enum Column { NameColumn, VolumeColumn, CodeColumn, RemarkColumn };
constexpr int labelRole = Qt::UserRole;

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

/// "Kidney, Right"
QString codeText(const core::Segment& segment, const core::SegCodes& codes)
{
    QStringList words{segment.code.meaning};
    for (const core::CodedConcept* code : {&codes.modifier, &codes.region, &codes.regionModifier}) {
        if (code->isSet())
            words += code->meaning;
    }
    return words.join(QStringLiteral(", "));
}

/// Which labels grow after each row of a history, from the first on.
class GrowingAlong {
public:
    explicit GrowingAlong(const core::Document& document)
        : m_document(document)
    {
    }

    void follow(const core::HistoryRow& row)
    {
        if (const std::optional<int> label = core::segmentOfSeeds(row.edit)) {
            const core::Segment* segment = m_document.segment(*label);
            Growing& growing = m_growths[segment ? segment->plane : std::uint8_t(0)];
            growing.seeded.set(std::size_t(*label));
            growing.pending.set(std::size_t(*label));
        }
        core::visitAmong(
            [&](const auto& known) { take(known, row.statistics); }, row.edit, core::GrowthKinds());
    }
    [[nodiscard]] std::bitset<256> labels() const
    {
        std::bitset<256> labels;
        for (const auto& [plane, growing] : m_growths)
            labels |= growing.grown ? growing.pending : growing.seeded;
        return labels;
    }

private:
    struct Growing {
        std::bitset<256> seeded;
        std::bitset<256> pending; ///< since the last growth
        bool grown = false; ///< to closure
    };

    template <class E>
    requires core::isOneOf<E, core::GrowSteps, core::ChangeInterval>
    void take(const E& growth, const core::EditStatistics& statistics)
    {
        Growing& growing = m_growths[core::growthPlaneOf(growth.criteria.plane)];
        growing.pending.reset();
        // A row without a number of steps ran to closure; so did one that stopped early.
        growing.grown = !growth.steps || statistics.generations < *growth.steps;
    }
    void take(const core::ShrinkSteps& shrink, const core::EditStatistics&)
    {
        m_growths[core::growthPlaneOf(shrink.plane)].grown = false;
    }
    /// After these a growth counts as finished if it did before. Seeds are counted by follow(),
    /// since painted ones are of no kind of growth; ResumeGrowth stands in no row.
    template <class E>
    requires core::isOneOf<E, core::SeedStroke, core::BarrierStroke, core::ResumeGrowth,
        core::ShrinkAt, core::PlugLeak, core::GrowFromSeeds>
    void take(const E&, const core::EditStatistics&) { }

    const core::Document& m_document;
    std::map<std::uint8_t, Growing> m_growths; ///< by label plane
};

} // namespace

std::bitset<256> growingLabels(core::EditSession& session)
{
    const core::History& history = session.history();
    GrowingAlong growing(session.document());
    for (const core::RowId id : history.standing())
        growing.follow(history.row(id));
    return growing.labels();
}

ExportSegments::ExportSegments(Workspace& workspace, QWidget* parent)
    : QTreeWidget(parent)
    , m_workspace(workspace)
{
    setObjectName(QStringLiteral("exportSegments"));
    setHeaderLabels({tr("Segment"), tr("Volume"), tr("Code"), tr("Remarks")});
    headerItem()->setTextAlignment(VolumeColumn, Qt::AlignRight | Qt::AlignVCenter);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setSelectionMode(QAbstractItemView::NoSelection);
    header()->setSectionResizeMode(RemarkColumn, QHeaderView::Stretch);
    setItemDelegateForColumn(VolumeColumn, new NumberDelegate(this));
    setColumnWidth(NameColumn, 200);
    setColumnWidth(VolumeColumn, 90);
    setColumnWidth(CodeColumn, 190);
    fill();
    connect(this, &QTreeWidget::itemChanged, this, [this](const QTreeWidgetItem* item) {
        if (m_filling)
            return;
        const auto label = std::size_t(item->data(NameColumn, labelRole).toInt());
        m_unticked.set(label, item->checkState(NameColumn) != Qt::Checked);
        Q_EMIT changed();
    });
    connect(this, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item, int column) {
        if (column == CodeColumn)
            chooseCode(item);
    });
    connect(&m_workspace, &Workspace::documentChanged, this,
        [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Segments)
                fill();
        });
}

std::vector<core::Segment> ExportSegments::chosen() const
{
    std::vector<core::Segment> segments;
    const core::EditSession* session = m_workspace.session();
    for (int row = 0; session && row < topLevelItemCount(); ++row) {
        const QTreeWidgetItem* item = topLevelItem(row);
        const auto* segment =
            session->document().segment(item->data(NameColumn, labelRole).toInt());
        if (segment && item->checkState(NameColumn) == Qt::Checked)
            segments.push_back(*segment);
    }
    return segments;
}

void ExportSegments::fill()
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const bool first = topLevelItemCount() == 0;
    m_filling = true;
    clear();
    for (const core::ExportChoice& choice :
        core::exportChoices(session->document(), growingLabels(*session))) {
        if (first)
            m_unticked.set(choice.segment.label, !choice.chosen);
        addRow(choice);
    }
    // Counts of voxels are longer than millilitres.
    setColumnWidth(
        VolumeColumn, std::max(columnWidth(VolumeColumn), sizeHintForColumn(VolumeColumn)));
    m_filling = false;
    Q_EMIT changed();
}

void ExportSegments::tickAll(bool ticked)
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    for (const core::Segment& segment : session->document().segments)
        m_unticked.set(segment.label, !ticked || segment.voxels == 0);
    fill();
}

void ExportSegments::addRow(const core::ExportChoice& choice)
{
    const core::Segment& segment = choice.segment;
    QStringList remarks;
    for (const core::ExportRemark remark : choice.remarks)
        remarks += exportRemarkText(remark);
    auto* item = new QTreeWidgetItem(this);
    item->setText(NameColumn, segment.name);
    item->setData(NameColumn, labelRole, int(segment.label));
    QPixmap swatch(12, 12);
    swatch.fill(QColor(segment.rgb));
    item->setIcon(NameColumn, QIcon(swatch));
    item->setCheckState(NameColumn, m_unticked.test(segment.label) ? Qt::Unchecked : Qt::Checked);
    item->setText(VolumeColumn, millilitreText(*m_workspace.volume(), segment.voxels));
    item->setTextAlignment(VolumeColumn, Qt::AlignRight | Qt::AlignVCenter);
    item->setText(CodeColumn,
        segment.code.isSet() ? codeText(segment, m_codes[segment.label]) : tr("choose …"));
    item->setToolTip(CodeColumn, tr("Click to choose what the segment is"));
    item->setForeground(CodeColumn, segment.code.isSet() ? theme::text : theme::accent);
    item->setText(RemarkColumn, remarks.join(QStringLiteral(", ")));
    item->setForeground(RemarkColumn, theme::caution);
}

void ExportSegments::chooseCode(QTreeWidgetItem* item)
{
    core::EditSession* session = m_workspace.session();
    const int label = item->data(NameColumn, labelRole).toInt();
    const core::Segment* segment = session ? session->document().segment(label) : nullptr;
    if (!segment)
        return;
    CodeDialog dialog(segment->name, segment->code, this);
    dialog.askDetails(m_codes[label]);
    if (dialog.exec() != QDialog::Accepted || session != m_workspace.session())
        return;
    m_codes[label] = dialog.details();
    core::ChangeSegment edit;
    edit.segment = label;
    edit.code = dialog.code();
    if (const auto applied = session->apply(edit); !applied)
        Q_EMIT failed(applied.error());
    fill();
}

} // namespace ui
