// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QString>

namespace core {

/// When a row of the history was made, by whom, and with which program.
struct RowOrigin {
    QDateTime at; ///< UTC, to the millisecond; invalid: not recorded
    QString author; ///< as the user chose to be named; may be empty
    QString program; ///< "burin 0.1.0"
};

/// The origin of a row made now by this program. The author is empty unless @p author is given.
[[nodiscard]] RowOrigin presentOrigin(const QString& author = QString());

} // namespace core
