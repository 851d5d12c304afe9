// SPDX-License-Identifier: Apache-2.0
#include "ui/models/HistoryModel.h"

#include "core/edits/DocumentEdits.h"
#include "ui/CountText.h"
#include "ui/Workspace.h"

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

RowText textOf(const core::HistoryRow& row)
{
    const qsizetype comma =
        core::changesDocumentOnly(row.edit) ? -1 : row.name.lastIndexOf(QLatin1String(", "));
    if (comma < 0)
        return {row.name, {}};
    return {row.name.left(comma), row.name.mid(comma + 2)};
}

} // namespace

HistoryModel::HistoryModel(Workspace& workspace, QObject* parent)
    : QAbstractListModel(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        beginResetModel();
        m_rows.clear();
        m_position = 0;
        if (const core::History* rows = history()) {
            m_rows = rows->line();
            m_rows.insert(m_rows.begin(), 0);
            m_position = rows->position();
        }
        endResetModel();
        Q_EMIT currentRowChanged(currentRow());
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History
                || change.what == core::DocumentChange::What::Segments)
                refresh();
        });
    if (const core::History* rows = history()) {
        m_rows = rows->line();
        m_rows.insert(m_rows.begin(), 0);
        m_position = rows->position();
    }
}

const core::History* HistoryModel::history() const
{
    const core::EditSession* session = m_workspace.session();
    return session ? &session->history() : nullptr;
}

void HistoryModel::refresh()
{
    const core::History* rows = history();
    if (!rows)
        return;
    std::vector<core::RowId> line = rows->line();
    line.insert(line.begin(), 0);
    const auto apart = std::mismatch(m_rows.begin(), m_rows.end(), line.begin(), line.end());
    const int kept = int(apart.first - m_rows.begin());
    if (kept < int(m_rows.size())) {
        beginRemoveRows({}, kept, int(m_rows.size()) - 1);
        m_rows.resize(std::size_t(kept));
        endRemoveRows();
    }
    if (kept < int(line.size())) {
        beginInsertRows({}, kept, int(line.size()) - 1);
        m_rows = std::move(line);
        endInsertRows();
    }
    m_position = rows->position();
    if (!m_rows.empty())
        Q_EMIT dataChanged(index(0), index(int(m_rows.size()) - 1));
    Q_EMIT currentRowChanged(currentRow());
}

int HistoryModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}

int HistoryModel::currentRow() const
{
    const auto found = std::find(m_rows.begin(), m_rows.end(), m_position);
    return found == m_rows.end() ? -1 : int(found - m_rows.begin());
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const
{
    const core::History* rows = history();
    if (!rows || !checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const core::RowId id = m_rows[std::size_t(index.row())];
    const core::HistoryRow* row = id == 0 ? nullptr : &rows->row(id);
    switch (role) {
    case Qt::AccessibleTextRole:
        return row ? row->name : tr("Study opened");
    case Qt::DisplayRole:
        return row ? textOf(*row).name : tr("Study opened");
    case Qt::ToolTipRole:
        return row ? tr("%1\nDouble click goes to the state after this step").arg(row->name)
                   : tr("Double click goes back to the beginning");
    case DetailRole:
        return row ? textOf(*row).detail : QString();
    case CurrentRole:
        return id == m_position;
    case VoxelsRole:
        return row && !core::changesDocumentOnly(row->edit);
    case UndoneRole:
        return index.row() > currentRow();
    case RowIdRole:
        return qlonglong(id);
    default:
        return {};
    }
}

QString HistoryModel::summary() const
{
    const core::History* rows = history();
    if (!rows)
        return {};
    std::size_t bytes = 0;
    for (const core::HistoryRow& row : rows->rows())
        bytes += row.deltaBytes;
    const QString steps = counted(currentRow(), tr("1 step"), tr("%1 steps"));
    return bytes == 0 ? steps
                      : tr("%1 · %2").arg(steps, QLocale().formattedDataSize(qint64(bytes), 0));
}

} // namespace ui
