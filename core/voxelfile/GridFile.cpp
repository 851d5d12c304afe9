// SPDX-License-Identifier: Apache-2.0
#include "core/voxelfile/GridFile.h"

#include <QFile>
#include <QFileInfo>

#include <cmath>

namespace core {

Result<QByteArray> readTextHeader(
    const QString& path, const std::function<bool(const QByteArray&, qsizetype)>& isRead)
{
    constexpr qint64 step = 65536;
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, path, file.errorString());
    if (file.size() == 0)
        return failure(ErrorCode::FileTruncated, path, Clause::saying("it holds no bytes"));
    QByteArray bytes;
    while (bytes.size() < longestTextHeader) {
        const qsizetype before = bytes.size();
        bytes += file.read(step);
        if (bytes.size() == before || isRead(bytes, before))
            return bytes;
    }
    return failure(
        ErrorCode::FileUnreadable, path, Clause::saying("its header does not come to an end"));
}

Result<void> setGridSize(GridFile& grid, std::span<const qint64> sides)
{
    constexpr qint64 longestSide = 32768;
    QStringList words;
    bool sound = sides.size() == 3;
    for (const qint64 side : sides) {
        sound = sound && side >= 1 && side <= longestSide;
        words.append(QString::number(side));
    }
    if (!sound) {
        return failure(ErrorCode::InvalidGeometry, grid.voxels.header,
            Clause::saying("%1 voxels", words.join(QStringLiteral(" × "))));
    }
    grid.geometry.size = {int(sides[0]), int(sides[1]), int(sides[2])};
    grid.voxels.voxels = grid.geometry.voxelCount();
    return {};
}

Result<void> checkGridAxes(const VolumeGeometry& geometry, const QString& path, const Clause& where)
{
    const double volume = geometry.voxelVolumeMm3();
    bool finite = std::isfinite(volume) && volume > 0.0;
    for (int column = 0; column < 4; ++column)
        finite = finite && std::isfinite(glm::length(glm::dvec3(geometry.indexToWorld[column])));
    if (finite)
        return {};
    return failure(ErrorCode::InvalidGeometry, path,
        Clause::saying("its axes do not span a volume (%1)", where));
}

Result<SeriesEntry> entryOf(const GridFile& grid)
{
    if (const Result<void> there = checkVoxelFiles(grid.voxels); !there)
        return tl::unexpected(there.error());
    SeriesEntry entry;
    entry.geometry = grid.geometry;
    entry.problems = grid.problems;
    entry.files = {grid.voxels.header};
    for (const QString& file : grid.voxels.files) {
        if (file != grid.voxels.header)
            entry.files.append(file);
    }
    entry.identity.seriesDescription = QFileInfo(grid.voxels.header).fileName();
    return entry;
}

Result<LoadedVolume> loadGridFile(
    const GridFile& grid, const SeriesEntry& entry, const QString& format, const Progress& progress)
{
    LoadedVolume loaded;
    Volume& volume = loaded.volume;
    volume.identity = entry.identity;
    volume.geometry = grid.geometry;
    volume.sourceFormat = format;
    volume.problems = grid.problems;
    const auto noteSurplus = [&volume](bool surplus) {
        if (surplus)
            volume.problems.push_back(
                {.kind = VolumeProblem::Kind::Other, .said = {ProblemCode::MoreThanVoxels}});
    };
    const ScalarType type = grid.voxels.type;
    if (!fitsCodes(type)) {
        const Result<VoxelBytes> bytes = readVoxels(grid.voxels, progress);
        if (!bytes)
            return tl::unexpected(bytes.error());
        noteSurplus(bytes->surplus);
        encodeScalars(loaded, {bytes->data.get(), bytes->size}, type, 1.0, 0.0, false);
        return loaded;
    }
    if (const Result<void> there = checkVoxelFiles(grid.voxels); !there)
        return tl::unexpected(there.error());
    if (const Result<void> fits = checkScalarMemory(grid.voxels.voxels, type); !fits)
        return tl::unexpected(fits.error());
    const Result<bool> surplus =
        readVoxelsInto(grid.voxels, roomForScalars(loaded, type), progress);
    if (!surplus)
        return tl::unexpected(surplus.error());
    noteSurplus(*surplus);
    encodeScalarsInRoom(loaded, type, 1.0, 0.0, false);
    return loaded;
}

} // namespace core
