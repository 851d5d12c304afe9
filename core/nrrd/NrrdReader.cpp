// SPDX-License-Identifier: Apache-2.0
#include "core/nrrd/NrrdReader.h"

#include "core/nrrd/NrrdGeometry.h"
#include "core/nrrd/NrrdHeader.h"
#include "core/voxelfile/VoxelFileNames.h"

#include <map>
#include <optional>

namespace core {

namespace {

std::optional<ScalarType> typeNamed(const QByteArray& name)
{
    static const std::map<QByteArray, ScalarType> types{
        {"signed char", ScalarType::Int8},
        {"int8", ScalarType::Int8},
        {"int8_t", ScalarType::Int8},
        {"uchar", ScalarType::UInt8},
        {"unsigned char", ScalarType::UInt8},
        {"uint8", ScalarType::UInt8},
        {"uint8_t", ScalarType::UInt8},
        {"short", ScalarType::Int16},
        {"short int", ScalarType::Int16},
        {"signed short", ScalarType::Int16},
        {"signed short int", ScalarType::Int16},
        {"int16", ScalarType::Int16},
        {"int16_t", ScalarType::Int16},
        {"ushort", ScalarType::UInt16},
        {"unsigned short", ScalarType::UInt16},
        {"unsigned short int", ScalarType::UInt16},
        {"uint16", ScalarType::UInt16},
        {"uint16_t", ScalarType::UInt16},
        {"int", ScalarType::Int32},
        {"signed int", ScalarType::Int32},
        {"int32", ScalarType::Int32},
        {"int32_t", ScalarType::Int32},
        {"uint", ScalarType::UInt32},
        {"unsigned int", ScalarType::UInt32},
        {"uint32", ScalarType::UInt32},
        {"uint32_t", ScalarType::UInt32},
        {"longlong", ScalarType::Int64},
        {"long long", ScalarType::Int64},
        {"long long int", ScalarType::Int64},
        {"signed long long", ScalarType::Int64},
        {"signed long long int", ScalarType::Int64},
        {"int64", ScalarType::Int64},
        {"int64_t", ScalarType::Int64},
        {"ulonglong", ScalarType::UInt64},
        {"unsigned long long", ScalarType::UInt64},
        {"unsigned long long int", ScalarType::UInt64},
        {"uint64", ScalarType::UInt64},
        {"uint64_t", ScalarType::UInt64},
        {"float", ScalarType::Float32},
        {"double", ScalarType::Float64},
    };
    const auto found = types.find(name.toLower().simplified());
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

Result<void> setEncoding(VoxelSource& source, const NrrdHeader& header)
{
    const auto unsupported = [&](const Clause& what) {
        return failure(ErrorCode::UnsupportedFormat, source.header, what);
    };
    const QByteArray typeName = header.field("type");
    const std::optional<ScalarType> type = typeNamed(typeName);
    if (!type)
        return unsupported(
            Clause::saying("voxels of type '%1'", QString::fromLatin1(typeName.left(40))));
    source.type = *type;
    const QByteArray encoding = header.field("encoding").toLower();
    if (encoding == "raw")
        source.encoding = VoxelSource::Encoding::Raw;
    else if (encoding == "gzip" || encoding == "gz")
        source.encoding = VoxelSource::Encoding::Gzip;
    else if (encoding == "ascii" || encoding == "text" || encoding == "txt")
        source.encoding = VoxelSource::Encoding::Text;
    else if (encoding == "hex")
        source.encoding = VoxelSource::Encoding::Hex;
    else if (encoding == "bzip2" || encoding == "bz2")
        return unsupported(Clause::saying("its voxels are packed with bzip2; gzip can be read"));
    else
        return unsupported(
            Clause::saying("voxels in the encoding '%1'", QString::fromLatin1(encoding.left(40))));

    const QByteArray endian = header.field("endian").toLower();
    source.bigEndian = endian == "big";
    const bool matters =
        bytesPerScalar(source.type) > 1 && source.encoding != VoxelSource::Encoding::Text;
    if (matters && endian != "big" && endian != "little")
        return failure(ErrorCode::FileUnreadable, source.header,
            Clause::saying("its header does not say the order of bytes (endian)"));
    return {};
}

Result<void> setSkips(VoxelSource& source, const NrrdHeader& header)
{
    for (const auto& [name, skip] : {std::pair("lineskip", &VoxelSource::lineSkip),
             std::pair("byteskip", &VoxelSource::byteSkip)}) {
        const QByteArray text = header.field(name);
        if (text.isEmpty())
            continue;
        bool isNumber = false;
        const qint64 count = text.toLongLong(&isNumber);
        const bool toEnd = count == -1 && skip == &VoxelSource::byteSkip
            && source.encoding == VoxelSource::Encoding::Raw;
        constexpr qint64 most = qint64(1) << 50;
        if (!isNumber || (count < 0 && !toEnd) || count > most)
            return failure(ErrorCode::FileUnreadable, source.header,
                Clause::saying(
                    "its header skips '%1' bytes or lines", QString::fromLatin1(text.left(40))));
        source.atEnd = source.atEnd || toEnd;
        source.*skip = toEnd ? 0 : count;
    }
    return {};
}

Result<void> setFiles(GridFile& grid, const NrrdHeader& header)
{
    VoxelSource& source = grid.voxels;
    if (!header.isDetached()) {
        source.files = {source.header};
        source.start = header.bytes.size();
        return {};
    }
    Result<QStringList> files =
        namedVoxelFiles(source.header, header.field("datafile"), header.list);
    if (!files)
        return tl::unexpected(files.error());
    // Files hold slabs of the slowest axis, or whole slices, or whole rows.
    const glm::ivec3 size = grid.geometry.size;
    const qint64 rows = qint64(size.y) * size.z;
    const qint64 count = files->size();
    if (size.z % count != 0 && count != rows)
        return failure(ErrorCode::FileUnreadable, source.header,
            Clause::saying("%1 files cannot hold %2 slices", count, size.z));
    source.files = std::move(*files);
    return {};
}

Result<GridFile> gridOf(const NrrdHeader& header, const QString& path)
{
    GridFile grid;
    grid.voxels.header = path;
    if (const Result<void> set = setNrrdGeometry(grid, header); !set)
        return tl::unexpected(set.error());
    if (const Result<void> set = setEncoding(grid.voxels, header); !set)
        return tl::unexpected(set.error());
    if (const Result<void> set = setSkips(grid.voxels, header); !set)
        return tl::unexpected(set.error());
    if (const Result<void> set = setFiles(grid, header); !set)
        return tl::unexpected(set.error());
    return grid;
}

/// The first of the words of a field, which go with the axes, taken away.
QByteArray dropFirstWord(QByteArray& text)
{
    text = text.simplified();
    const qsizetype end = text.indexOf(' ');
    const QByteArray word = end < 0 ? text : text.left(end);
    text = end < 0 ? QByteArray() : text.mid(end + 1);
    return word;
}

/// Takes a first axis of four away where it is none of space. @return its length; 1: there is none
int takeFirstAxis(NrrdHeader& header)
{
    const QByteArray kinds = header.field("kinds").toLower().simplified();
    const bool beyondSpace = header.field("spacedirections").simplified().startsWith("none")
        || kinds.startsWith("list") || kinds.startsWith("vector");
    constexpr int mostLayers = 255;
    const auto sizes = wholeNumbers(header.field("sizes"));
    if (!beyondSpace || header.field("dimension") != "4" || !sizes || sizes->size() != 4
        || sizes->front() < 1 || sizes->front() > mostLayers)
        return 1;
    header.fields["dimension"] = "3";
    for (const char* name : {"sizes", "kinds", "spacedirections", "spacings", "axismins",
             "axismaxs", "centerings", "centers"}) {
        if (const auto field = header.fields.find(name); field != header.fields.end())
            static_cast<void>(dropFirstWord(field->second));
    }
    for (const char* name : {"units", "labels", "thicknesses"})
        header.fields.erase(name);
    return int(sizes->front());
}

} // namespace

bool isNrrdName(const QString& path)
{
    return path.endsWith(QLatin1String(".nrrd"), Qt::CaseInsensitive)
        || path.endsWith(QLatin1String(".nhdr"), Qt::CaseInsensitive);
}

Result<GridFile> readNrrd(const QString& path)
{
    const Result<NrrdHeader> header = readNrrdHeader(path);
    if (!header)
        return tl::unexpected(header.error());
    return gridOf(*header, path);
}

Result<NrrdLayers> readNrrdLayers(const QString& path)
{
    Result<NrrdHeader> header = readNrrdHeader(path);
    if (!header)
        return tl::unexpected(header.error());
    const int layers = takeFirstAxis(*header);
    Result<GridFile> grid = gridOf(*header, path);
    if (!grid)
        return tl::unexpected(grid.error());
    grid->voxels.voxels *= std::size_t(layers);
    return NrrdLayers{
        .grid = *std::move(grid), .layers = layers, .keyValues = std::move(header->keyValues)};
}

Result<SeriesEntry> readNrrdEntry(const QString& path)
{
    const Result<GridFile> grid = readNrrd(path);
    if (!grid)
        return tl::unexpected(grid.error());
    return entryOf(*grid);
}

Result<VolumeGeometry> nrrdGeometryOf(const QByteArray& header, const QString& path)
{
    const Result<NrrdHeader> words = parseNrrdHeader(header, path);
    if (!words)
        return tl::unexpected(words.error());
    GridFile grid;
    grid.voxels.header = path;
    if (const Result<void> set = setNrrdGeometry(grid, *words); !set)
        return tl::unexpected(set.error());
    return grid.geometry;
}

Result<LoadedVolume> loadNrrd(const SeriesEntry& entry, const Progress& progress)
{
    const Result<GridFile> grid = readNrrd(entry.files.front());
    if (!grid)
        return tl::unexpected(grid.error());
    return loadGridFile(*grid, entry, QStringLiteral("NRRD"), progress);
}

QByteArray nrrdHeaderBytes(const QString& path)
{
    const Result<NrrdHeader> header = readNrrdHeader(path);
    return header ? header->bytes : QByteArray();
}

} // namespace core
