// SPDX-License-Identifier: Apache-2.0
#include "core/nifti/NiftiReader.h"

#include "core/voxelfile/StoredScalars.h"

#include <QFile>
#include <QFileInfo>

#include <nifti1_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace core {

namespace {

constexpr QLatin1String headerEnding(".hdr");

struct FreeImage {
    void operator()(nifti_image* image) const { nifti_image_free(image); }
};
using Image = std::unique_ptr<nifti_image, FreeImage>;

Image readImage(const QString& path)
{
    nifti_set_debug_level(0);
    return Image(nifti_image_read(QFile::encodeName(path).constData(), 0));
}

std::optional<ScalarType> scalarType(int type)
{
    switch (type) {
    case DT_UINT8:
        return ScalarType::UInt8;
    case DT_INT8:
        return ScalarType::Int8;
    case DT_INT16:
        return ScalarType::Int16;
    case DT_UINT16:
        return ScalarType::UInt16;
    case DT_INT32:
        return ScalarType::Int32;
    case DT_UINT32:
        return ScalarType::UInt32;
    case DT_INT64:
        return ScalarType::Int64;
    case DT_UINT64:
        return ScalarType::UInt64;
    case DT_FLOAT32:
        return ScalarType::Float32;
    case DT_FLOAT64:
        return ScalarType::Float64;
    default:
        return std::nullopt;
    }
}

double millimetresPerUnit(int units)
{
    switch (units) {
    case NIFTI_UNITS_METER:
        return 1000.0;
    case NIFTI_UNITS_MICRON:
        return 0.001;
    default:
        return 1.0;
    }
}

glm::dmat4 lpsFromRas(const mat44& ras, double scale)
{
    glm::dmat4 lps(1.0);
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            const double sign = row == 2 ? 1.0 : -1.0;
            lps[column][row] = sign * scale * double(ras.m[row][column]);
        }
    }
    return lps;
}

glm::dmat4 affine(const nifti_image& image, std::vector<VolumeProblem>& problems)
{
    const double scale = millimetresPerUnit(image.xyz_units);
    if (image.sform_code > 0)
        return lpsFromRas(image.sto_xyz, scale);
    if (image.qform_code > 0)
        return lpsFromRas(image.qto_xyz, scale);
    problems.push_back(
        {.kind = VolumeProblem::Kind::Other, .said = {ProblemCode::SidesAssumed}, .caution = true});
    glm::dmat4 lps(1.0);
    lps[0][0] = -scale * double(image.dx);
    lps[1][1] = -scale * double(image.dy);
    lps[2][2] = scale * double(image.dz);
    return lps;
}

/// The file with the voxels: the same one, or that beside a header of its own; empty if there is
/// none. The library would rather take another volume of that name.
QString voxelFileOf(const nifti_image& image, const QString& path)
{
    if (isNiftiName(path) || image.nifti_type == NIFTI_FTYPE_NIFTI1_1)
        return path;
    const QString base = path.chopped(headerEnding.size());
    for (const char* ending : {".img", ".img.gz", ".IMG", ".IMG.GZ"}) {
        if (QString file = base + QLatin1String(ending); QFileInfo(file).isFile())
            return file;
    }
    return {};
}

/// Whether a file can hold the voxels of a point in time. A header of a few bytes may claim
/// gigabytes; memory is not asked for what the file cannot hold.
/// @param path from voxelFileOf() @param bytes of one point
bool mayHold(const QString& path, std::size_t bytes, int time)
{
    constexpr std::size_t mostPerPackedByte = 1032; // deflate's limit
    const auto stored = std::size_t(QFileInfo(path).size());
    const int isPacked = nifti_is_gzfile(QFile::encodeName(path).constData());
    return (std::size_t(time) + 1) * bytes <= stored * (isPacked != 0 ? mostPerPackedByte : 1);
}

/// Reads the voxels of a point in time in the machine's byte order; false if the file does not hold
/// them all. The library's own reader fills what is missing with zeros and turns NaN into 0, both
/// without a word.
/// @param path from voxelFileOf() @param voxels as many bytes as one point has
bool readVoxels(const nifti_image& image, const QString& path, std::span<char> voxels, int time)
{
    const std::size_t bytes = voxels.size();
    const std::size_t before = std::size_t(time) * bytes;
    const QByteArray name = QFile::encodeName(path);
    znzFile file = znzopen(name.constData(), "rb", nifti_is_gzfile(name.constData()));
    if (znz_isnull(file))
        return false;
    std::size_t done = 0;
    if (znzseek(file, long(image.iname_offset) + long(before), SEEK_SET) >= 0) {
        // In pieces: one call for more than 4 GiB would wrap in zlib.
        constexpr std::size_t piece = std::size_t(1) << 28;
        while (done < bytes) {
            const std::size_t got =
                znzread(voxels.data() + done, 1, std::min(piece, bytes - done), file);
            if (got == 0 || got > bytes - done)
                break;
            done += got;
        }
    }

    Xznzclose(&file);
    if (done < bytes)
        return false;
    if (image.swapsize > 1 && image.byteorder != nifti_short_order()) {
        nifti_swap_Nbytes(bytes / std::size_t(image.swapsize), image.swapsize, voxels.data());
    }
    return true;
}

/// A file of which all but the voxels was read.
struct Opened {
    Image image;
    QString path;
    QString voxelFile{};
    NiftiNumbers numbers{}; ///< without bytes
    std::size_t bytes = 0; ///< of the voxels of one point in time

    [[nodiscard]] tl::unexpected<Error> incomplete() const
    {
        return failure(ErrorCode::FileTruncated, path,
            voxelFile == path ? Clause::saying("its voxels are incomplete")
                              : Clause::saying("its voxels in %1 are incomplete", voxelFile));
    }
};

/// Errors: FileTruncated, also where the file is too short for that point; OutOfMemory.
Result<Opened> openNumbers(const SeriesEntry& entry, int time)
{
    Opened opened{.image = readImage(entry.files.front()), .path = entry.files.front()};
    const nifti_image* image = opened.image.get();
    const std::optional<ScalarType> type = image ? scalarType(image->datatype) : std::nullopt;
    opened.voxelFile = image ? voxelFileOf(*image, opened.path) : opened.path;
    if (!type || opened.voxelFile.isEmpty())
        return opened.incomplete();
    opened.bytes = entry.geometry.voxelCount() * bytesPerScalar(*type);
    if (!mayHold(opened.voxelFile, opened.bytes, time))
        return opened.incomplete();
    if (const Result<void> fits = checkScalarMemory(entry.geometry.voxelCount(), *type); !fits)
        return tl::unexpected<Error>(fits.error());
    opened.numbers.type = *type;
    // A slope of 0 means that there is none (nifti1.h).
    if (image->scl_slope != 0.0f && std::isfinite(image->scl_slope)
        && std::isfinite(image->scl_inter)) {
        opened.numbers.slope = double(image->scl_slope);
        opened.numbers.intercept = double(image->scl_inter);
    }
    if (image->cal_max > image->cal_min && std::isfinite(image->cal_max)
        && std::isfinite(image->cal_min)) {
        opened.numbers.window = {.centre = (double(image->cal_max) + double(image->cal_min)) / 2.0,
            .width = double(image->cal_max) - double(image->cal_min)};
    }
    return opened;
}

/// Which of several this is, as of DICOM series in time.
VolumeProblem pointInTime(int count, int time)
{
    return {.kind = VolumeProblem::Kind::MixedSlices,
        .said = {ProblemCode::PointInTime, {count, std::int64_t(time) + 1}}};
}

} // namespace

bool isNiftiName(const QString& path)
{
    return path.endsWith(QLatin1String(".nii"), Qt::CaseInsensitive)
        || path.endsWith(QLatin1String(".nii.gz"), Qt::CaseInsensitive);
}

bool isNiftiFile(const QString& path)
{
    if (isNiftiName(path))
        return true;
    // Other formats have headers of that name, and DICOM may have any.
    if (!path.endsWith(headerEnding, Qt::CaseInsensitive) || !QFileInfo(path).isFile())
        return false;
    QFile file(path);
    const QByteArray size = file.open(QIODevice::ReadOnly) ? file.read(4) : QByteArray();
    return size == QByteArray("\x5c\x01\0\0", 4) || size == QByteArray("\0\0\x01\x5c", 4);
}

Result<SeriesEntry> readNiftiEntry(const QString& path)
{
    if (QFileInfo(path).size() == 0)
        return failure(ErrorCode::FileTruncated, path, Clause::saying("it holds no bytes"));
    const Image image = readImage(path);
    if (!image)
        return failure(ErrorCode::FileUnreadable, path, Clause::saying("not a sound NIfTI header"));
    // Programs disagree about what such headers leave open: images were mirrored that way.
    if (image->nifti_type == NIFTI_FTYPE_ANALYZE && !isNiftiName(path)) {
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("an Analyze 7.5 header, which does not say which side is left; convert "
                           "it to NIfTI"));
    }
    const QString voxels = voxelFileOf(*image, path);
    if (voxels.isEmpty()) {
        return failure(ErrorCode::FileUnreadable, path,
            Clause::saying("its voxels are not beside it (%1.img)",
                QFileInfo(path.chopped(headerEnding.size())).fileName()));
    }
    for (int axis = 5; axis <= 7; ++axis) {
        if (axis <= image->ndim && image->dim[axis] > 1) {
            return failure(ErrorCode::UnsupportedFormat, path,
                Clause::saying("it holds %1 numbers for each voxel", image->dim[axis]));
        }
    }
    if (!scalarType(image->datatype)) {
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying(
                "voxels of type %1", QLatin1String(nifti_datatype_string(image->datatype))));
    }
    constexpr int longestSide = 32768;
    if (image->nx < 1 || image->ny < 1 || image->nz < 1 || image->nx > longestSide
        || image->ny > longestSide || image->nz > longestSide) {
        return failure(ErrorCode::InvalidGeometry, path,
            Clause::saying("%1 × %2 × %3 voxels", image->nx, image->ny, image->nz));
    }
    SeriesEntry entry;
    entry.geometry.size = {image->nx, image->ny, image->nz};
    entry.geometry.indexToWorld = affine(*image, entry.problems);
    entry.files = {path};
    if (voxels != path)
        entry.files.append(voxels);
    if (image->ndim >= 4 && image->dim[4] > 1) {
        // Nothing says whether they are moments, directions or echoes.
        entry.times.set(image->dim[4] - 1, Clause());
        entry.problems.push_back(pointInTime(image->dim[4], 0));
    }
    entry.identity.seriesDescription = QFileInfo(path).fileName();
    const double volume = entry.geometry.voxelVolumeMm3();
    if (!std::isfinite(volume) || volume <= 0.0) {
        return failure(ErrorCode::InvalidGeometry, path,
            Clause::saying("its axes do not span a volume (sform or qform)"));
    }
    return entry;
}

Result<NiftiNumbers> readNiftiNumbers(const SeriesEntry& entry, int time)
{
    Result<Opened> opened = openNumbers(entry, time);
    if (!opened)
        return tl::unexpected(opened.error());
    std::vector<char>& bytes = opened->numbers.bytes;
    bytes.resize(opened->bytes);
    if (!readVoxels(*opened->image, opened->voxelFile, bytes, time))
        return opened->incomplete();
    return std::move(opened->numbers);
}

Result<LoadedVolume> loadNifti(const SeriesEntry& entry, int time, const Progress& progress)
{
    progress.report(ProgressStep::ReadingVoxels, 0, 1);
    const Result<Opened> opened = openNumbers(entry, time);
    if (!opened)
        return tl::unexpected(opened.error());
    const NiftiNumbers& numbers = opened->numbers;
    LoadedVolume loaded;
    Volume& volume = loaded.volume;
    volume.identity = entry.identity;
    volume.geometry = entry.geometry;
    volume.sourceFormat = QStringLiteral("NIfTI");
    volume.problems = entry.problems;
    if (!entry.times.isEmpty())
        volume.problems.back() = pointInTime(int(entry.times.size()), time);
    if (numbers.window)
        volume.defaultWindow = *numbers.window;
    const bool inRoom = fitsCodes(numbers.type);
    std::vector<char> wide(inRoom ? 0 : opened->bytes);
    const std::span<char> voxels =
        inRoom ? roomForScalars(loaded, numbers.type) : std::span<char>(wide);
    if (!readVoxels(*opened->image, opened->voxelFile, voxels, time))
        return opened->incomplete();
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    const bool hasWindow = numbers.window.has_value();
    if (inRoom)
        encodeScalarsInRoom(loaded, numbers.type, numbers.slope, numbers.intercept, hasWindow);
    else
        encodeScalars(loaded, voxels, numbers.type, numbers.slope, numbers.intercept, hasWindow);
    return loaded;
}

QByteArray niftiHeaderBytes(const QString& path)
{
    nifti_set_debug_level(0);
    const std::unique_ptr<nifti_1_header, decltype(&std::free)> header(
        nifti_read_header(QFile::encodeName(path).constData(), nullptr, 1), &std::free);
    if (!header)
        return {};
    return {reinterpret_cast<const char*>(header.get()), qsizetype(sizeof(nifti_1_header))};
}

} // namespace core
