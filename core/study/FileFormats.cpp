// SPDX-License-Identifier: Apache-2.0
#include "core/study/FileFormats.h"

#include "core/images/ImageStack.h"
#include "core/metaimage/MetaImageReader.h"
#include "core/nifti/NiftiReader.h"
#include "core/nrrd/NrrdReader.h"

#include <algorithm>
#include <array>

namespace core {

namespace {

/// Pictures are many files: Study::scan() finds them by itself, exports and sessions by name.
bool isNoName(const QString&)
{
    return false;
}

/// For formats whose volumes are of one moment.
template <auto load>
Result<LoadedVolume> loadOnly(const SeriesEntry& entry, int, const Progress& progress)
{
    return load(entry, progress);
}

constexpr std::array formats{
    FileFormat{.name = "NIfTI",
        .isName = isNiftiFile,
        .read = readNiftiEntry,
        .load = loadNifti,
        .headerBytes = niftiHeaderBytes,
        .geometryOf = nullptr},
    FileFormat{.name = "NRRD",
        .isName = isNrrdName,
        .read = readNrrdEntry,
        .load = loadOnly<loadNrrd>,
        .headerBytes = nrrdHeaderBytes,
        .geometryOf = nrrdGeometryOf},
    FileFormat{.name = "MetaImage",
        .isName = isMetaImageName,
        .read = readMetaImageEntry,
        .load = loadOnly<loadMetaImage>,
        .headerBytes = metaImageHeaderBytes,
        .geometryOf = metaImageGeometryOf},
    FileFormat{.name = imageFormatName,
        .isName = isNoName,
        .read = nullptr,
        .load = nullptr,
        .headerBytes = imageStackHeader,
        .geometryOf = imageStackGeometryOf},
};

template <class Matches> const FileFormat* find(const Matches& matches)
{
    const auto* found = std::find_if(formats.begin(), formats.end(), matches);
    return found == formats.end() ? nullptr : found;
}

} // namespace

const FileFormat* fileFormatOf(const QString& path)
{
    return find([&](const FileFormat& format) { return format.isName(path); });
}

const FileFormat* fileFormatNamed(const QString& name)
{
    return find([&](const FileFormat& format) { return name == QLatin1String(format.name); });
}

} // namespace core
