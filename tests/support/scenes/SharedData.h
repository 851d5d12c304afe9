// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>
#include <QString>

namespace test {

/// The shared test data: BURIN_SHARED_DATA, else beside the source tree; empty if there are none.
QString sharedDataFolder();

/// One case of the shared data.
struct SharedCase {
    QString source; ///< its folder, read only
    QString unpacked; ///< its archives, unpacked below the build folder; empty if it has none
    QJsonObject expected; ///< expected.json
};

/// Unpacks at first use, also when several tests want the same case at once. `source` is empty
/// where there are no shared data: QSKIP then.
SharedCase sharedCase(const QString& name);

} // namespace test
