// SPDX-License-Identifier: Apache-2.0
#include "core/nifti/NiftiWriter.h"

#include "core/base/StagedFile.h"
#include "core/nifti/NiftiHeader.h"

#include <QFile>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <limits>

namespace core {

namespace {

static_assert(
    std::endian::native == std::endian::little, "voxels are written as they lie in memory");

/// A gzip or plain stream that remembers the first error.
class OutputStream {
public:
    OutputStream(const QString& path, bool compressed)
    {
        errno = 0;
        m_stream = gzopen(QFile::encodeName(path).constData(), compressed ? "wb6" : "wbT");
        if (m_stream == nullptr)
            keepReason();
    }
    OutputStream(const OutputStream&) = delete;
    OutputStream& operator=(const OutputStream&) = delete;
    ~OutputStream() { close(); }

    void write(const void* bytes, std::size_t size)
    {
        constexpr std::size_t chunk = 1U << 26;
        const char* next = static_cast<const char*>(bytes);
        while (size > 0 && m_reason.isEmpty()) {
            const std::size_t part = std::min(size, chunk);
            errno = 0;
            if (gzwrite(m_stream, next, unsigned(part)) != int(part))
                keepReason();
            next += part;
            size -= part;
        }
    }

    /// @returns why the file is not whole; empty if it is
    QString close()
    {
        if (m_stream != nullptr) {
            errno = 0;
            if (gzclose(m_stream) != Z_OK && m_reason.isEmpty())
                keepReason();
            m_stream = nullptr;
        }
        return m_reason;
    }

private:
    void keepReason()
    {
        m_reason = errno != 0 ? QString::fromLocal8Bit(std::strerror(errno))
                              : QStringLiteral("compression failed");
    }

    gzFile m_stream = nullptr;
    QString m_reason;
};

} // namespace

Result<NiftiWritten> writeNiftiAt(const QString& path, const NiftiImage& image)
{
    const glm::ivec3 size = image.geometry.size;
    for (int axis = 0; axis < 3; ++axis) {
        if (size[axis] < 1 || size[axis] > std::numeric_limits<std::int16_t>::max())
            return failure(ErrorCode::UnsupportedFormat, path,
                QStringLiteral("NIfTI-1 holds sides of 1 to 32767 voxels, not %1").arg(size[axis]));
    }
    const auto voxels = std::visit([](auto span) { return std::as_bytes(span); }, image.voxels);
    static constexpr std::array<NiftiHeader::DataType, 3> types{
        NiftiHeader::DataType::UInt8, NiftiHeader::DataType::Int16, NiftiHeader::DataType::Float32};
    static constexpr std::array<std::size_t, 3> bytesPerVoxel{1, 2, 4};
    const std::size_t kind = image.voxels.index();
    if (voxels.size() != image.geometry.voxelCount() * bytesPerVoxel[kind])
        return failure(ErrorCode::UnsupportedFormat, path,
            QStringLiteral("the voxels are not as many as the grid has"));

    const NiftiHeader header =
        makeNiftiHeader(image.geometry, types[kind], image.description.toUtf8(), image.labels);
    OutputStream stream(path, path.endsWith(QLatin1String(".gz"), Qt::CaseInsensitive));
    stream.write(header.bytes.data(), header.bytes.size());
    stream.write(voxels.data(), voxels.size());
    if (const QString reason = stream.close(); !reason.isEmpty())
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
        error.arguments[0] = file;
        return tl::unexpected(error);
    }
    if (auto done = staged->commit(); !done)
        return tl::unexpected(done.error());
    return written;
}

} // namespace core
