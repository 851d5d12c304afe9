// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/ChangedRaycaster.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>

namespace test {

gpu::ShaderLibrary changedRaycaster(const QTemporaryDir& folder, const QByteArray& lines)
{
    const QString root = QStringLiteral(":/shaders/");
    QDirIterator files(root, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString path = files.next().mid(root.size());
        QFile from(root + path);
        QFile to(folder.filePath(path));
        if (!QDir().mkpath(QFileInfo(to).path()) || !from.open(QIODevice::ReadOnly)
            || !to.open(QIODevice::WriteOnly))
            qFatal("the shaders cannot be copied");
        if (path == QLatin1String("render/raycast/raycast.frag"))
            to.write(lines);
        to.write(from.readAll());
    }
    return gpu::ShaderLibrary(folder.path());
}

} // namespace test
