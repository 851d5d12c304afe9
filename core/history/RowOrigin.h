// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QString>

namespace core {

/// Who made a row of the history, when, and with which program.
struct RowOrigin {
    QDateTime at; ///< UTC, to the millisecond; invalid: not recorded
    QString author; ///< as the user chose to be named; may be empty
    QString program; ///< "burin 0.1.0"
};

/// Now, with this program. Nobody is named unless @p author is.
[[nodiscard]] RowOrigin presentOrigin(const QString& author = QString());

} // namespace core
