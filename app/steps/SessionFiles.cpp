// SPDX-License-Identifier: Apache-2.0
#include "app/steps/SessionFiles.h"

#include "core/base/files/PrivateFolder.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>

namespace app {

QString sessionFolder()
{
    QString state = qEnvironmentVariable("XDG_STATE_HOME");
    if (state.isEmpty())
        state = QDir::homePath() + QStringLiteral("/.local/state");
    const QString folder = state + QStringLiteral("/burin/sessions");
    core::makePrivateFolder(folder);
    return folder;
}

QString sessionFile(const core::Volume& volume)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(volume.identity.seriesUid.toUtf8());
    hash.addData(volume.voxelsSha256);
    // Repairs that come to the same voxels keep their own names in exports.
    hash.addData(volume.repair.toUtf8());
    const QString name = QString::fromLatin1(hash.result().toHex().left(24));
    return sessionFolder() + QLatin1Char('/') + name + QStringLiteral(".burin");
}

bool isWorkingSession(const QString& file)
{
    return QFileInfo(file).absoluteDir() == QDir(sessionFolder());
}

} // namespace app
