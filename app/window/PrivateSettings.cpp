// SPDX-License-Identifier: Apache-2.0
#include "app/window/PrivateSettings.h"

#include "core/base/files/PrivateFolder.h"

#include <QFileInfo>
#include <QSettings>

namespace app {

void keepSettingsPrivate()
{
    const QString own = QSettings().fileName();
    if (core::makePrivateFolder(QFileInfo(own).absolutePath()))
        core::makePrivateFile(own);
    // Its folder is shared with every other program: only the file is made private.
    const QString ofDialogs =
        QSettings(QSettings::UserScope, QStringLiteral("QtProject")).fileName();
    core::makePrivateFile(ofDialogs);
}

} // namespace app
