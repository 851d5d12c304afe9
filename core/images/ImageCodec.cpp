// SPDX-License-Identifier: Apache-2.0
#include "core/images/ImageCodec.h"

#include "core/fence/FencedDecoder.h"
#include "core/images/PngDecoder.h"
#include "core/images/TiffDecoder.h"
#include "core/images/TiffDirectory.h"

#include <QFile>

#include <cstring>
#include <type_traits>

namespace core {

namespace {

constexpr std::uint32_t imageMark = 0x50494354;

/// An ImagePage on its way to a decoder, which is the same program.
struct PageParameters {
    std::uint32_t mark = imageMark;
    std::int32_t isTiff = 0;
    std::int32_t columns = 0;
    std::int32_t rows = 0;
    std::int32_t pixelBytes = 0;
};
static_assert(std::is_trivially_copyable_v<PageParameters>);

/// What a decoder reads: of PNG the file, of TIFF the page alone. Empty if it is not there.
QByteArray codedBytes(const ImagePage& page)
{
    if (page.form == ImagePage::Form::Tiff)
        return tiffOfPage(page);
    QFile file(page.file);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

Clause decodeImageFenced(
    const ImagePage& page, const std::function<void(std::span<const std::uint8_t> pixels)>& take)
{
    const QByteArray bytes = codedBytes(page);
    if (bytes.isEmpty())
        return Clause::saying("it cannot be read any more");
    const PageParameters parameters{.isTiff = page.form == ImagePage::Form::Tiff ? 1 : 0,
        .columns = page.columns,
        .rows = page.rows,
        .pixelBytes = std::int32_t(bytesPerScalar(page.type))};
    return FencedDecoder::instance().decode(
        {reinterpret_cast<const std::uint8_t*>(&parameters), sizeof(parameters)},
        {reinterpret_cast<const std::uint8_t*>(bytes.constData()), std::size_t(bytes.size())},
        page.byteCount(), take);
}

bool isImageRequest(std::span<const std::uint8_t> parameters)
{
    return parameters.size() == sizeof(PageParameters)
        && std::memcmp(parameters.data(), &imageMark, sizeof(imageMark)) == 0;
}

QString decodeImageHere(std::span<const std::uint8_t> parameters,
    std::span<const std::uint8_t> bytes, std::span<std::uint8_t> pixels)
{
    PageParameters known;
    if (!isImageRequest(parameters))
        return QStringLiteral("a picture of unknown form");
    std::memcpy(&known, parameters.data(), sizeof(known));
    const PixelGrid grid{
        .columns = known.columns, .rows = known.rows, .pixelBytes = std::size_t(known.pixelBytes)};
    if (grid.byteCount() != pixels.size())
        return QStringLiteral("a picture of unknown size");
    return known.isTiff != 0 ? decodeTiff(bytes, grid, pixels) : decodePng(bytes, grid, pixels);
}

} // namespace core
