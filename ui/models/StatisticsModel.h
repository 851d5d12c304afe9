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

/// Item model of the statistics of segments (measure/LiveStatistics.h): a row per segment in the
/// document's order, a column per number. Its numbers are those that an export writes. The name is
/// in column 0, and with the colour in the vertical header.
class StatisticsModel : public SegmentRows<QAbstractTableModel> {
    Q_OBJECT

public:
    enum Role {
        LabelRole = Qt::UserRole, ///< int
        NumberRole, ///< double, as exported; none: there is no such number
        BehindRole, ///< bool: the segment has changed since
        KeyRole, ///< QString, of a column's header: its name in an exported table
        LongNameRole, ///< QString, of a column's header, without the unit
    };

    StatisticsModel(
        Workspace& workspace, const LiveStatistics& statistics, QObject* parent = nullptr);

    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;

    /// The column of a number, by its name in an exported table; −1: none.
    [[nodiscard]] static int columnOf(const QString& key);

private:
    void refresh();
    [[nodiscard]] const core::Segment* segmentAt(int row) const;
    [[nodiscard]] std::optional<double> numberAt(int row, int column) const;
    [[nodiscard]] QString textOf(double number, int column) const;
    [[nodiscard]] QString headingOf(int column) const;
    [[nodiscard]] QVariant rowHeader(int row, int role) const;
    [[nodiscard]] bool isInVoxels() const; ///< the spacing of the volume is unknown

    Workspace& m_workspace;
    const LiveStatistics& m_statistics;
};

} // namespace ui
