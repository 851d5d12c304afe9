// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/SharedData.h"

#include "tests/support/servers/Python.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QTemporaryDir>

namespace test {

namespace {

/// A folder with all archives of a case. Made under another name and renamed, so that whoever sees
/// it sees it whole.
QString unpack(const QDir& source, const QStringList& archives)
{
    const QString name = source.dirName();
    const QString root = QCoreApplication::applicationDirPath() + QStringLiteral("/shared-data");
    const QString target = root + QLatin1Char('/') + name;
    if (QDir(target).exists())
        return target;
    QDir().mkpath(root);
    QTemporaryDir temporary(root + QStringLiteral("/unpacking-XXXXXX"));
    for (const QString& archive : archives) {
        const ScriptOutput tar = runProgram(QStringLiteral("tar"),
            {QStringLiteral("xf"), source.filePath(archive), QStringLiteral("-C"),
                temporary.path()});
        if (tar.exitCode != 0)
            qFatal("%s: %s", qPrintable(archive), tar.output.constData());
    }
    if (QDir().rename(temporary.path(), target))
        temporary.setAutoRemove(false);
    return target;
}

} // namespace

QString sharedDataFolder()
{
    const QString named = qEnvironmentVariable("BURIN_SHARED_DATA");
    const QDir folder(named.isEmpty() ? QStringLiteral(BURIN_SOURCE_DIR "/../shared/data") : named);
    // A mount point without its mount holds nothing.
    return folder.exists() && !folder.isEmpty() ? folder.absolutePath() : QString();
}

SharedCase sharedCase(const QString& name)
{
    const QDir source(sharedDataFolder() + QLatin1Char('/') + name);
    if (sharedDataFolder().isEmpty() || !source.exists())
        return {};
    SharedCase result{.source = source.path(), .unpacked = {}, .expected = {}};
    QFile expected(source.filePath(QStringLiteral("expected.json")));
    if (expected.open(QIODevice::ReadOnly))
        result.expected = QJsonDocument::fromJson(expected.readAll()).object();
    const QStringList archives = source.entryList({QStringLiteral("*.tar.xz")}, QDir::Files);
    if (!archives.isEmpty())
        result.unpacked = unpack(source, archives);
    return result;
}

} // namespace test
