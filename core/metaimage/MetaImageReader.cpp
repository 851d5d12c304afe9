// SPDX-License-Identifier: Apache-2.0
#include "core/metaimage/MetaImageReader.h"

#include "core/metaimage/MetaImageHeader.h"
#include "core/voxelfile/VoxelFileNames.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace core {

namespace {

std::optional<ScalarType> typeNamed(const QByteArray& name)
{
    static const std::map<QByteArray, ScalarType> types{
        {"MET_CHAR", ScalarType::Int8},
        {"MET_UCHAR", ScalarType::UInt8},
        {"MET_SHORT", ScalarType::Int16},
        {"MET_USHORT", ScalarType::UInt16},
        {"MET_INT", ScalarType::Int32},
        {"MET_UINT", ScalarType::UInt32},
        // Four bytes in files, whatever the machine calls long.
        {"MET_LONG", ScalarType::Int32},
        {"MET_ULONG", ScalarType::UInt32},
        {"MET_LONG_LONG", ScalarType::Int64},
        {"MET_ULONG_LONG", ScalarType::UInt64},
        {"MET_FLOAT", ScalarType::Float32},
        {"MET_DOUBLE", ScalarType::Float64},
    };
    const auto found = types.find(name);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

/// The first of several names under which a field goes.
std::optional<std::vector<double>> numbersOf(
    const MetaImageHeader& header, std::initializer_list<const char*> names)
{
    for (const char* name : names) {
        if (header.has(name))
            return header.numbers(name);
    }
    return std::nullopt;
}

bool hasAny(const MetaImageHeader& header, std::initializer_list<const char*> names)
{
    return std::any_of(
        names.begin(), names.end(), [&](const char* name) { return header.has(name); });
}

constexpr std::initializer_list<const char*> originNames{"Offset", "Position", "Origin"};
constexpr std::initializer_list<const char*> matrixNames{
    "TransformMatrix", "Rotation", "Orientation"};
constexpr std::initializer_list<const char*> spacingNames{"ElementSpacing", "ElementSize"};

tl::unexpected<Error> refused(const QString& path, const Clause& reason)
{
    return failure(ErrorCode::FileUnreadable, path, reason);
}

/// Sides of the grid: two or three that are more than 1, filled up to three.
Result<std::vector<qint64>> sidesOf(const MetaImageHeader& header, const QString& path)
{
    constexpr double mostAxes = 10.0;
    const auto axes = header.numbers("NDims");
    if (!axes || axes->size() != 1 || !((*axes)[0] >= 1.0) || (*axes)[0] > mostAxes
        || (*axes)[0] != std::floor((*axes)[0]))
        return refused(path, Clause::saying("its header names no dimension (NDims)"));
    const auto sizes = header.numbers("DimSize");
    if (!sizes || sizes->size() != std::size_t((*axes)[0]))
        return refused(
            path, Clause::saying("its header does not name a size for each axis (DimSize)"));
    std::vector<qint64> sides;
    for (const double size : *sizes) {
        constexpr double most = 1e15;
        if (!(size >= 1.0) || size > most || size != std::floor(size))
            return refused(path, Clause::saying("its header names a size of %1", size));
        sides.push_back(qint64(size));
    }
    if (sides.size() < 2)
        return failure(ErrorCode::UnsupportedFormat, path, Clause::saying("it holds no slices"));
    for (std::size_t axis = 3; axis < sides.size(); ++axis) {
        if (sides[axis] > 1)
            return failure(ErrorCode::UnsupportedFormat, path,
                Clause::saying("it holds %1 volumes", sides[axis]));
    }
    return sides;
}

Result<void> setGeometry(GridFile& grid, const MetaImageHeader& header)
{
    const QString& path = grid.voxels.header;
    const Result<std::vector<qint64>> sides = sidesOf(header, path);
    if (!sides)
        return tl::unexpected(sides.error());
    const std::size_t axes = sides->size();
    const std::size_t used = std::min<std::size_t>(axes, 3);

    const auto spacing = numbersOf(header, spacingNames);
    const auto origin = numbersOf(header, originNames);
    const auto matrix = numbersOf(header, matrixNames);
    const auto caution = [&](VolumeProblem::Kind kind, ProblemCode code) {
        grid.problems.push_back({.kind = kind, .said = {code}, .caution = true});
    };
    if (hasAny(header, spacingNames) && (!spacing || spacing->size() != axes))
        return refused(path, Clause::saying("its header does not have a spacing for each axis"));
    if (hasAny(header, originNames) && (!origin || origin->size() != axes))
        return refused(path, Clause::saying("its header does not name the place of a voxel"));
    if (hasAny(header, matrixNames) && (!matrix || matrix->size() != axes * axes))
        return refused(path, Clause::saying("its header does not have a direction for each axis"));

    glm::dmat4& affine = grid.geometry.indexToWorld;
    for (std::size_t axis = 0; axis < used; ++axis) {
        const double step = spacing ? (*spacing)[axis] : 1.0;
        // The matrix lies in the file direction after direction.
        for (std::size_t part = 0; matrix && part < used; ++part)
            affine[int(axis)][int(part)] = (*matrix)[axis * axes + part];
        affine[int(axis)] *= step;
        affine[3][int(axis)] = origin ? (*origin)[axis] : 0.0;
    }
    if (!matrix) {
        caution(VolumeProblem::Kind::Other, ProblemCode::AxesAssumed);
    }
    if (!spacing) {
        caution(VolumeProblem::Kind::AssumedSpacing, ProblemCode::SpacingAssumed);
    }
    if (axes == 2) {
        caution(VolumeProblem::Kind::AssumedSpacing, ProblemCode::ThicknessAssumed);
    }
    std::vector<qint64> three = *sides;
    three.resize(3, 1);
    if (const Result<void> sized = setGridSize(grid, three); !sized)
        return sized;
    return checkGridAxes(grid.geometry, path, Clause::saying("TransformMatrix or ElementSpacing"));
}

Result<void> setEncoding(VoxelSource& source, const MetaImageHeader& header)
{
    const auto unsupported = [&](const Clause& what) {
        return failure(ErrorCode::UnsupportedFormat, source.header, what);
    };
    const QByteArray typeName = header.field("ElementType");
    const std::optional<ScalarType> type = typeNamed(typeName);
    if (!type)
        return unsupported(
            Clause::saying("voxels of type '%1'", QString::fromLatin1(typeName.left(40))));
    source.type = *type;
    if (header.has("ElementNumberOfChannels") && header.field("ElementNumberOfChannels") != "1")
        return unsupported(Clause::saying("it holds %1 values per voxel",
            QString::fromLatin1(header.field("ElementNumberOfChannels").left(20))));
    source.bigEndian =
        header.flag("ElementByteOrderMSB", header.flag("BinaryDataByteOrderMSB", false));
    if (!header.flag("BinaryData", true))
        source.encoding = VoxelSource::Encoding::Text;
    else if (header.flag("CompressedData", false))
        source.encoding = VoxelSource::Encoding::Zlib;

    if (const QByteArray text = header.field("HeaderSize"); !text.isEmpty()) {
        bool isNumber = false;
        const qint64 skip = text.toLongLong(&isNumber);
        constexpr qint64 most = qint64(1) << 50;
        const bool raw = source.encoding == VoxelSource::Encoding::Raw;
        if (!isNumber || skip < -1 || skip > most || (skip != 0 && !raw))
            return refused(source.header,
                Clause::saying(
                    "its header has a HeaderSize of '%1'", QString::fromLatin1(text.left(40))));
        source.atEnd = skip == -1;
        source.byteSkip = std::max<qint64>(skip, 0);
    }
    return {};
}

Result<void> setFiles(GridFile& grid, const MetaImageHeader& header)
{
    VoxelSource& source = grid.voxels;
    const QByteArray text = header.field("ElementDataFile");
    if (text.toUpper() == "LOCAL") {
        source.files = {source.header};
        source.start = header.bytes.size();
        return {};
    }
    Result<QStringList> files = namedVoxelFiles(source.header, text, header.list);
    if (!files)
        return tl::unexpected(files.error());
    const qint64 count = files->size();
    if (grid.geometry.size.z % count != 0)
        return refused(source.header,
            Clause::saying("%1 files cannot hold %2 slices", count, grid.geometry.size.z));
    source.files = std::move(*files);
    return {};
}

} // namespace

bool isMetaImageName(const QString& path)
{
    return path.endsWith(QLatin1String(".mha"), Qt::CaseInsensitive)
        || path.endsWith(QLatin1String(".mhd"), Qt::CaseInsensitive);
}

Result<GridFile> readMetaImage(const QString& path)
{
    const Result<MetaImageHeader> header = readMetaImageHeader(path);
    if (!header)
        return tl::unexpected(header.error());
    GridFile grid;
    grid.voxels.header = path;
    if (const Result<void> set = setGeometry(grid, *header); !set)
        return tl::unexpected(set.error());
    if (const Result<void> set = setEncoding(grid.voxels, *header); !set)
        return tl::unexpected(set.error());
    if (const Result<void> set = setFiles(grid, *header); !set)
        return tl::unexpected(set.error());
    return grid;
}

Result<SeriesEntry> readMetaImageEntry(const QString& path)
{
    const Result<GridFile> grid = readMetaImage(path);
    if (!grid)
        return tl::unexpected(grid.error());
    return entryOf(*grid);
}

Result<LoadedVolume> loadMetaImage(const SeriesEntry& entry, const Progress& progress)
{
    const Result<GridFile> grid = readMetaImage(entry.files.front());
    if (!grid)
        return tl::unexpected(grid.error());
    return loadGridFile(*grid, entry, QStringLiteral("MetaImage"), progress);
}

QByteArray metaImageHeaderBytes(const QString& path)
{
    const Result<MetaImageHeader> header = readMetaImageHeader(path);
    return header ? header->bytes : QByteArray();
}

Result<VolumeGeometry> metaImageGeometryOf(const QByteArray& header, const QString& path)
{
    const Result<MetaImageHeader> words = parseMetaImageHeader(header, path);
    if (!words)
        return tl::unexpected(words.error());
    GridFile grid;
    grid.voxels.header = path;
    if (const Result<void> set = setGeometry(grid, *words); !set)
        return tl::unexpected(set.error());
    return grid.geometry;
}

} // namespace core
