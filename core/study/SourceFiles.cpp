// SPDX-License-Identifier: Apache-2.0
#include "core/study/SourceFiles.h"

#include "core/images/ImagePage.h"
#include "core/images/ImageStack.h"

#include <QDir>
#include <QFileInfo>

namespace core {

QStringList sourceFiles(const Volume& volume)
{
    QStringList files;
    const auto add = [&files](const std::vector<SourceSlice>& slices) {
        for (const SourceSlice& slice : slices) {
            // The frames of one file follow each other.
            if (!slice.file.isEmpty() && (files.isEmpty() || files.back() != slice.file))
                files += slice.file;
        }
    };
    const QFileInfo source(volume.sourcePath);
    if (source.isFile())
        files += volume.sourcePath;
    add(volume.sources);
    if (volume.asIs)
        add(volume.asIs->sources);
    if (volume.sourceFormat == QLatin1String(imageFormatName) && source.isDir()) {
        const QDir folder(volume.sourcePath);
        for (const QString& name : folder.entryList(QDir::Files)) {
            if (isImageName(name))
                files += folder.filePath(name);
        }
    }
    return files;
}

} // namespace core
