// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study/StudyLoader.h"

#include <QFile>
#include <QTemporaryDir>

#include <memory>

namespace test {

[[nodiscard]] inline bool sameAffine(const glm::dmat4& a, const glm::dmat4& b)
{
    for (int column = 0; column < 4; ++column) {
        if (glm::length(a[column] - b[column]) > 1e-9)
            return false;
    }
    return true;
}

/// A folder, new for every test function, for volumes that are written byte by byte.
class VolumeFiles {
protected:
    void makeFolder() { m_folder = std::make_unique<QTemporaryDir>(); }
    /// @return its path
    QString put(const QString& name, const QByteArray& bytes)
    {
        QFile file(m_folder->filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("cannot write %s", qPrintable(file.fileName()));
        return file.fileName();
    }
    core::Result<core::LoadedVolume> opened(const QString& name, const QByteArray& bytes)
    {
        return core::loadVolume(put(name, bytes));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

} // namespace test
