// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/models/SegmentRows.h"

#include <QAbstractTableModel>

#include <optional>

namespace core {
struct Segment;
struct SegmentStatistics;
} // namespace core

namespace ui {

class LiveStatistics;
class Workspace;

/// Item model of the statistics of segments (measure/LiveStatistics.h), with a row per segment in
/// the document's order and a column per number. The numbers are those that an export writes. The
/// segment's name is column 0 and also, with its colour, the vertical header.
class StatisticsModel : public SegmentRows<QAbstractTableModel> {
    Q_OBJECT

public:
    enum Role {
        LabelRole = Qt::UserRole, ///< int
        /// Double as exported, or the name in column 0; invalid: there is no such number.
        NumberRole,
        BehindRole, ///< bool: the segment has changed since it was measured
        KeyRole, ///< QString, of a column's header: its name in exported tables
        LongNameRole, ///< QString, of a column's header: the full name without the unit
    };

    StatisticsModel(
        Workspace& workspace, const LiveStatistics& statistics, QObject* parent = nullptr);

    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;

    /// Returns the column with a name in exported tables; −1 if there is none.
    [[nodiscard]] static int columnOf(const QString& key);

private:
    void refresh();
    [[nodiscard]] const core::Segment* segmentAt(int row) const;
    [[nodiscard]] std::optional<double> numberAt(int row, int column) const;
    [[nodiscard]] QString textOf(double number, int column) const;
    [[nodiscard]] QString headingOf(int column) const;
    [[nodiscard]] QVariant rowHeader(int row, int role) const;
    [[nodiscard]] bool isInVoxels() const; ///< whether the spacing of the volume is unknown

    Workspace& m_workspace;
    const LiveStatistics& m_statistics;
};

} // namespace ui
