// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/FuzzTargets.h"

#include "core/archive/ArchiveReader.h"

#include <QDirIterator>
#include <QFileInfo>

namespace test {

using namespace core;

void fuzzArchive(FuzzBytes bytes)
{
    constexpr QDir::Filters everything =
        QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot;
    // A tar is one by its name.
    for (const char* name : {"file.zip", "file.tar"}) {
        const ScratchFile file(name, bytes);
        if (!isArchive(file.path()))
            continue;
        const QDir around = QFileInfo(file.path()).dir();
        const QStringList before = around.entryList(everything);
        const QString folder = file.path() + QStringLiteral("-unpacked");
        if (!QDir().mkpath(folder))
            qFatal("no place for a folder");
        (void)unpackArchive(file.path(), folder, Progress());
        QDirIterator walk(folder, everything, QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            const QFileInfo info(walk.next());
            if (info.isSymLink() || !(info.isFile() || info.isDir()))
                qFatal("an archive made what is neither file nor folder");
        }
        QDir(folder).removeRecursively();
        if (around.entryList(everything) != before)
            qFatal("an archive wrote outside of its folder");
    }
}

} // namespace test
