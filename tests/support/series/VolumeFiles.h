// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study/StudyLoader.h"

#include <QFile>
#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <vector>

namespace test {

[[nodiscard]] inline bool sameAffine(const glm::dmat4& a, const glm::dmat4& b)
{
    for (int column = 0; column < 4; ++column) {
        if (glm::length(a[column] - b[column]) > 1e-9)
            return false;
    }
    return true;
}

/// A new folder for every test function, for volumes that are written byte by byte.
class VolumeFiles {
protected:
    /// @param name of the file that openBytes() writes
    explicit VolumeFiles(const char* name = "test")
        : m_name(QLatin1String(name))
    {
    }

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
    core::Result<core::LoadedVolume> openBytes(const QByteArray& bytes)
    {
        return opened(m_name, bytes);
    }

    // Checks for every reader of such files; each reports failures to Qt Test, as in a test
    // function.

    /// Splits voxels into files, one for each name, with @p before in front of each, compressed by
    /// @p pack if given.
    void putVoxels(const QByteArray& voxels, const QStringList& names, const QByteArray& before,
        const std::function<QByteArray(const QByteArray&)>& pack = {});
    /// Compares with the voxels of test::nrrd, raised by @p shift, on this grid.
    static void compareVoxels(const core::Result<core::LoadedVolume>& loaded,
        const glm::dmat4& indexToWorld, int shift = 0);
    /// Checks that the bytes are refused with this error, whose sentence names the file and @p
    /// reason.
    void compareRefusal(const QByteArray& bytes, core::ErrorCode code, const QString& reason);
    /// Checks that every truncation of a valid file is refused, with its name and a reason.
    void compareEveryCut(const QByteArray& sound);
    /// Checks that files with some bytes changed, removed or doubled are either opened or refused
    /// with a sentence.
    void compareRandomBytes(const std::vector<QByteArray>& kinds, unsigned int seed, int rounds);
    /// Checks that a mask belongs to the file: it no longer passes after @p moved replaces the
    /// file, and passes without the file if a session holds the images.
    void compareMasks(const QByteArray& sound, const QByteArray& moved);

    QString m_name;
    std::unique_ptr<QTemporaryDir> m_folder;
};

} // namespace test
