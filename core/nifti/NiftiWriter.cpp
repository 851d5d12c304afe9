// SPDX-License-Identifier: Apache-2.0
#include "core/nifti/NiftiWriter.h"

#include "core/base/files/StagedFile.h"
#include "core/nifti/NiftiHeader.h"
#include "core/voxelfile/PackedOutput.h"

#include <array>
#include <bit>
#include <limits>

namespace core {

namespace {

static_assert(
    std::endian::native == std::endian::little, "voxels are written as they lie in memory");

} // namespace

Result<NiftiWritten> writeNiftiAt(const QString& path, const NiftiImage& image)
{
    const glm::ivec3 size = image.geometry.size;
    for (int axis = 0; axis < 3; ++axis) {
        if (size[axis] < 1 || size[axis] > std::numeric_limits<std::int16_t>::max())
            return failure(ErrorCode::UnsupportedFormat, path,
                Clause::saying("NIfTI-1 holds sides of 1 to 32767 voxels, not %1", size[axis]));
    }
    const auto voxels = std::visit([](auto span) { return std::as_bytes(span); }, image.voxels);
    static constexpr std::array<NiftiHeader::DataType, 3> types{
        NiftiHeader::DataType::UInt8, NiftiHeader::DataType::Int16, NiftiHeader::DataType::Float32};
    static constexpr std::array<std::size_t, 3> bytesPerVoxel{1, 2, 4};
    const std::size_t kind = image.voxels.index();
    if (voxels.size() != image.geometry.voxelCount() * bytesPerVoxel[kind])
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("the voxels are not as many as the grid has"));

    const NiftiHeader header =
        makeNiftiHeader(image.geometry, types[kind], image.description.toUtf8(), image.labels);
    const bool packed = path.endsWith(QLatin1String(".gz"), Qt::CaseInsensitive);
    PackedOutput stream(path, packed ? PackedOutput::Form::Gzip : PackedOutput::Form::Plain);
    stream.write(header.bytes.data(), header.bytes.size());
    stream.write(voxels.data(), voxels.size());
    if (const Clause reason = stream.close(); !reason.isEmpty())
        return failure(ErrorCode::FileUnwritable, path, reason);
    return NiftiWritten{header.qform};
}

Result<NiftiWritten> writeNifti(const QString& file, const NiftiImage& image, bool replaceExisting)
{
    auto staged = StagedFile::create(file, replaceExisting);
    if (!staged)
        return tl::unexpected(staged.error());
    auto written = writeNiftiAt(staged->path(), image);
    if (!written) {
        Error error = written.error();
        error.arguments.set(0, file);
        return tl::unexpected(error);
    }
    if (auto done = staged->commit(); !done)
        return tl::unexpected(done.error());
    return written;
}

} // namespace core
