// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <cstdint>
#include <span>

namespace test {

using FuzzBytes = std::span<const std::uint8_t>;

/// A folder with one file, in memory where there is such a place.
class ScratchFile {
public:
    ScratchFile(const char* name, FuzzBytes bytes)
        : m_path(folder().filePath(QLatin1String(name)))
    {
        QFile file(m_path);
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no place for a file");
        file.write(reinterpret_cast<const char*>(bytes.data()), qint64(bytes.size()));
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    ~ScratchFile() { QFile::remove(m_path); }

    [[nodiscard]] const QString& path() const { return m_path; }

private:
    static QTemporaryDir& folder()
    {
        static QTemporaryDir made(QDir(QStringLiteral("/dev/shm")).exists()
                ? QStringLiteral("/dev/shm/burin-fuzz-XXXXXX")
                : QStringLiteral("burin-fuzz-XXXXXX"));
        return made;
    }

    QString m_path;
};

/// The volume that masks are laid on.
inline core::Volume smallVolume()
{
    core::Volume volume;
    volume.geometry.size = {24, 20, 16};
    volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(1.5, 0, 0, 0), glm::dvec4(0, 1.5, 0, 0),
        glm::dvec4(0, 0, 2, 0), glm::dvec4(-10, -10, -10, 1));
    return volume;
}

} // namespace test
