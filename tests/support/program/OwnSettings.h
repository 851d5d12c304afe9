// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>

namespace test {

/// Gives a test class settings of its own, in a folder that is removed with this object.
class OwnSettings {
public:
    OwnSettings()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("burin-test"));
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
    }
    /// Empties the settings, as if the program had never been used.
    static void clear() { QSettings().clear(); }

private:
    QTemporaryDir m_folder;
};

} // namespace test
