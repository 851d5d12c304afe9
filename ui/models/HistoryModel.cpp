// SPDX-License-Identifier: Apache-2.0
#include "ui/models/HistoryModel.h"

#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"
#include "ui/base/NumberText.h"
#include "ui/base/RowTitleText.h"
#include "ui/models/ViewStepText.h"
#include "ui/workspace/ViewSteps.h"
#include "ui/workspace/Workspace.h"

#include <QLocale>

#include <algorithm>

namespace ui {

namespace {

QString counted(qlonglong count, const QString& one, const QString& many)
{
    return count == 1 ? one : many.arg(countText(count));
}

/// Names of strokes and growths end in what they changed ("Drill 6.2 mm, 214 bricks"); a row shows
/// that at its right end.
struct RowText {
    QString name;
    QString detail;
};

RowText shownOf(const core::HistoryRow& row)
{
    const bool hasFigures =
        !core::changesDocumentOnly(row.edit) || core::taskOf(row.edit) == core::EditTask::Surface;
    if (row.title && hasFigures && !row.title->then.empty())
        return {textOf(core::headlineOf(*row.title)), textOf(row.title->then.back())};
    if (row.title)
        return {textOf(*row.title), {}};
    const qsizetype comma = hasFigures ? row.name.lastIndexOf(QLatin1String(", ")) : -1;
    if (comma < 0)
        return {row.name, {}};
    return {row.name.left(comma), row.name.mid(comma + 2)};
}

bool isSameEntry(const HistoryEntry& a, const HistoryEntry& b)
{
    return a.row == b.row && a.branch == b.branch && a.depth == b.depth
        && a.isHeading() == b.isHeading() && a.viewStep == b.viewStep;
}

} // namespace

HistoryModel::HistoryModel(Workspace& workspace, QObject* parent)
    : QAbstractListModel(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        beginResetModel();
        reset();
        endResetModel();
        Q_EMIT currentRowChanged(currentRow());
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History
                || change.what == core::DocumentChange::What::Segments)
                refresh();
        });
    connect(&workspace.viewSteps(), &ViewSteps::changed, this, &HistoryModel::refresh);
    reset();
}

const core::History* HistoryModel::history() const
{
    const core::EditSession* session = m_workspace.session();
    return session ? &session->history() : nullptr;
}

void HistoryModel::reset()
{
    const core::History* rows = history();
    m_unfolded.clear();
    m_outline = rows ? outlined(*rows) : HistoryOutline();
    m_position = rows ? rows->position() : 0;
    findPosition();
}

HistoryOutline HistoryModel::outlined(const core::History& rows) const
{
    return HistoryOutline::of(rows, m_unfolded, m_workspace.viewSteps().counts());
}

void HistoryModel::refresh()
{
    const core::History* rows = history();
    if (!rows)
        return;
    m_position = rows->position();
    list(outlined(*rows));
    Q_EMIT currentRowChanged(currentRow());
}

void HistoryModel::list(HistoryOutline outline)
{
    std::vector<HistoryEntry>& old = m_outline.entries;
    const std::vector<HistoryEntry>& now = outline.entries;
    const auto kept =
        std::mismatch(old.begin(), old.end(), now.begin(), now.end(), isSameEntry).first
        - old.begin();
    // What follows a change is the same again when something was folded, or forked further up.
    const auto tail =
        std::mismatch(old.rbegin(), old.rend() - kept, now.rbegin(), now.rend() - kept, isSameEntry)
            .first
        - old.rbegin();
    const int removed = int(old.size()) - int(kept + tail);
    const int inserted = int(now.size()) - int(kept + tail);
    if (removed > 0) {
        beginRemoveRows({}, int(kept), int(kept) + removed - 1);
        old.erase(old.begin() + kept, old.begin() + kept + removed);
        findPosition();
        endRemoveRows();
    }
    if (inserted > 0)
        beginInsertRows({}, int(kept), int(kept) + inserted - 1);
    m_outline = std::move(outline);
    findPosition();
    if (inserted > 0)
        endInsertRows();
    if (!m_outline.entries.empty())
        Q_EMIT dataChanged(index(0), index(rowCount() - 1));
}

void HistoryModel::findPosition()
{
    const std::vector<HistoryEntry>& entries = m_outline.entries;
    const auto isThere = [this](const HistoryEntry& entry) {
        return entry.depth == 0 && entry.row == m_position;
    };
    auto found = std::find_if(entries.begin(), entries.end(), isThere);
    m_linePosition = found == entries.end() ? -1 : found->lineIndex;
    // Its changes of the view follow it, those that are done first.
    const int done = m_workspace.viewSteps().at(m_position).done;
    for (auto next = found; next != entries.end() && isThere(*next) && next->viewStep <= done;
         ++next)
        found = next;
    m_currentRow = found == entries.end() ? -1 : int(found - entries.begin());
}

int HistoryModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_outline.entries.size());
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const
{
    if (!history() || !checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const HistoryEntry& entry = m_outline.entries[std::size_t(index.row())];
    switch (role) {
    case CurrentRole:
        return index.row() == m_currentRow;
    case UndoneRole:
        return entry.viewStep > 0 ? entry.viewStep > m_workspace.viewSteps().at(entry.row).done
                                  : entry.depth == 0 && entry.lineIndex > m_linePosition;
    case RowIdRole:
        return qlonglong(entry.row);
    case ViewStepRole:
        return entry.viewStep;
    case DepthRole:
        return entry.depth;
    case HeadingRole:
        return entry.isHeading();
    case FoldedRole:
        return entry.folded;
    case LastRole:
        return entry.last;
    case DoneBelowRole:
        return index.row() < m_currentRow;
    default:
        return entry.isHeading() ? headingData(entry, role)
            : entry.viewStep > 0 ? viewStepData(entry, role)
                                 : rowData(entry, role);
    }
}

QVariant HistoryModel::headingData(const HistoryEntry& entry, int role) const
{
    const QString last = shownOf(history()->row(entry.row)).name;
    const QString steps = counted(entry.steps, tr("1 step"), tr("%1 steps"));
    switch (role) {
    case Qt::AccessibleTextRole:
        return entry.folded ? tr("Branch, folded: %1, last '%2'").arg(steps, last)
                            : tr("Branch, unfolded: %1, last '%2'").arg(steps, last);
    case Qt::DisplayRole:
        return tr("Branch to %1").arg(last);
    case DetailRole:
        return steps;
    case Qt::ToolTipRole:
        return tr("Branch: %1, last '%2'\n"
                  "The arrow shows its steps, a double click goes to its end")
            .arg(steps, nameOf(history()->row(entry.row)));
    case VoxelsRole:
        return false;
    default:
        return {};
    }
}

QVariant HistoryModel::rowData(const HistoryEntry& entry, int role) const
{
    const core::HistoryRow* row = entry.row == 0 ? nullptr : &history()->row(entry.row);
    switch (role) {
    case Qt::AccessibleTextRole:
        return row ? nameOf(*row) : tr("Study opened");
    case Qt::DisplayRole:
        return row ? shownOf(*row).name : tr("Study opened");
    case Qt::ToolTipRole:
        return row ? tr("%1\nDouble click goes to the state after this step").arg(nameOf(*row))
                   : tr("Double click goes back to the beginning");
    case DetailRole:
        return row ? shownOf(*row).detail : QString();
    case VoxelsRole:
        return row && !core::changedPart(row->edit);
    default:
        return {};
    }
}

QVariant HistoryModel::viewStepData(const HistoryEntry& entry, int role) const
{
    const ViewSteps::Steps steps = m_workspace.viewSteps().at(entry.row);
    // While the list is on its way to what the steps are now.
    if (entry.viewStep > int(steps.all.size()))
        return {};
    const QString text = viewStepText(
        steps.all[std::size_t(entry.viewStep - 1)], &m_workspace.session()->document());
    switch (role) {
    case Qt::AccessibleTextRole:
        return tr("%1, a way of viewing").arg(text);
    case Qt::DisplayRole:
        return text;
    case DetailRole:
        return tr("view");
    case Qt::ToolTipRole:
        return tr("%1\nA way of viewing: undo takes it back, but it is no step of the session")
            .arg(text);
    case VoxelsRole:
        return false;
    default:
        return {};
    }
}

bool HistoryModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != FoldedRole || !history() || !checkIndex(index, CheckIndexOption::IndexIsValid))
        return false;
    const HistoryEntry entry = m_outline.entries[std::size_t(index.row())];
    if (!entry.isHeading() || entry.folded == value.toBool())
        return false;
    if (value.toBool())
        m_unfolded.erase(entry.branch);
    else
        m_unfolded.insert(entry.branch);
    list(outlined(*history()));
    return true;
}

QModelIndex HistoryModel::indexOnLine(int lineIndex) const
{
    const std::vector<HistoryEntry>& entries = m_outline.entries;
    const auto found =
        std::find_if(entries.begin(), entries.end(), [lineIndex](const HistoryEntry& entry) {
            return entry.depth == 0 && entry.lineIndex == lineIndex;
        });
    return found == entries.end() ? QModelIndex() : index(int(found - entries.begin()));
}

QModelIndex HistoryModel::headingOf(const QModelIndex& index) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const core::RowId branch = m_outline.entries[std::size_t(index.row())].branch;
    for (int row = index.row(); branch != 0 && row >= 0; --row) {
        const HistoryEntry& entry = m_outline.entries[std::size_t(row)];
        if (entry.isHeading() && entry.branch == branch)
            return this->index(row);
    }
    return {};
}

QString HistoryModel::summary() const
{
    const core::History* rows = history();
    if (!rows)
        return {};
    std::size_t bytes = 0;
    for (const core::HistoryRow& row : rows->rows())
        bytes += row.deltaBytes;
    QStringList parts{counted(m_linePosition, tr("1 step"), tr("%1 steps"))};
    if (m_outline.branches > 0)
        parts += counted(m_outline.branches, tr("1 branch"), tr("%1 branches"));
    if (bytes > 0)
        parts += QLocale().formattedDataSize(qint64(bytes), 0);
    return parts.join(QStringLiteral(" · "));
}

} // namespace ui
