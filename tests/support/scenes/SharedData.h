// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>
#include <QString>

namespace test {

/// The folder of the shared test data: BURIN_SHARED_DATA, else beside the source tree; empty if
/// there is none.
QString sharedDataFolder();

/// One case of the shared data.
struct SharedCase {
    QString source; ///< its folder, read only
    QString unpacked; ///< its archives, unpacked below the build folder; empty if it has none
    QJsonObject expected; ///< expected.json
};

/// Finds a case and unpacks it at first use, also when several tests need it at the same time.
/// `source` is empty without shared data; then use QSKIP.
SharedCase sharedCase(const QString& name);

} // namespace test
