// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>

namespace test {

/// Settings that a class of tests has to itself, in a folder that goes with it.
class OwnSettings {
public:
    OwnSettings()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("burin-test"));
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
    }
    /// As where the program was never used.
    static void clear() { QSettings().clear(); }

private:
    QTemporaryDir m_folder;
};

} // namespace test
