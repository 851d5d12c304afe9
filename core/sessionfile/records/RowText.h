// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/delta/BrickDelta.h"
#include "core/history/History.h"

#include <QJsonObject>
#include <QString>

namespace core {

/// A row of the history in the form of the session file, and the hashes that link the rows
/// (core/session/README.md). All hashes are hex SHA-256.
struct RowText {
    RowId id = 0;
    RowId parent = 0;
    QString name;
    QString edit; ///< compact JSON
    QString statistics; ///< compact JSON
    qint64 growthGeneration = 0;
    QString at; ///< ISO 8601, UTC, with milliseconds; empty: not recorded
    QString author;
    QString program;
    QString title; ///< compact JSON; empty: none is kept. No hash covers it

    [[nodiscard]] static RowText of(const HistoryRow& row);
    /// The row without its second half. Errors: those of editFromJson().
    [[nodiscard]] Result<HistoryRow> row() const;
    /// The chain of this row. @param previous the chain of the row before it
    [[nodiscard]] QString chain(const QString& previous) const;
};

/// Whether an edit of older rows names one that does not lie before its own row, which only a
/// forged file contains: following such names might never end.
[[nodiscard]] bool namesNoEarlierRow(RowId id, const Edit& edit);

/// The chain of row 0. @param source the source's JSON as it stands in the file
[[nodiscard]] QString firstChain(const QString& source);
[[nodiscard]] QString seal(
    const QString& chain, const QString& stateHash, const QString& deltaSha256);
[[nodiscard]] QString sha256(const BrickDelta& delta);

/// JSON without white space; all text of the file has this form.
[[nodiscard]] QString compact(const QJsonObject& object);
/// Empty if the text is no JSON object.
[[nodiscard]] QJsonObject parsed(const QString& text);

} // namespace core
