// SPDX-License-Identifier: Apache-2.0
#include "core/images/TiffDirectory.h"
#include "core/images/TiffTags.h"

#include <QDataStream>
#include <QFile>

#include <cstdint>
#include <limits>
#include <vector>

namespace core {

namespace {

struct Field {
    tiff::Tag tag;
    std::uint32_t value = 0;
    const std::vector<std::uint32_t>* list = nullptr; ///< instead of the value
};

int sampleFormat(ScalarType type)
{
    if (isFloating(type))
        return 3;
    const bool isSigned =
        type == ScalarType::Int8 || type == ScalarType::Int16 || type == ScalarType::Int32;
    return isSigned ? 2 : 1;
}

/// Tags in ascending order, as the format wants them.
std::vector<Field> fieldsOf(const ImagePage& page, const std::vector<std::uint32_t>& offsets,
    const std::vector<std::uint32_t>& sizes)
{
    std::vector<Field> fields{
        {.tag = tiff::ImageWidth, .value = std::uint32_t(page.columns)},
        {.tag = tiff::ImageLength, .value = std::uint32_t(page.rows)},
        {.tag = tiff::BitsPerSample, .value = std::uint32_t(8 * bytesPerScalar(page.type))},
        {.tag = tiff::Compression, .value = std::uint32_t(page.compression)},
        {.tag = tiff::Photometric, .value = 1},
    };
    if (!page.isTiled)
        fields.push_back({.tag = tiff::StripOffsets, .list = &offsets});
    fields.push_back({.tag = tiff::SamplesPerPixel, .value = 1});
    if (!page.isTiled) {
        fields.push_back({.tag = tiff::RowsPerStrip, .value = std::uint32_t(page.partRows)});
        fields.push_back({.tag = tiff::StripByteCounts, .list = &sizes});
    }
    fields.push_back({.tag = tiff::PlanarConfiguration, .value = 1});
    if (page.predictor != 1)
        fields.push_back({.tag = tiff::Predictor, .value = std::uint32_t(page.predictor)});
    if (page.isTiled) {
        fields.push_back({.tag = tiff::TileWidth, .value = std::uint32_t(page.partColumns)});
        fields.push_back({.tag = tiff::TileLength, .value = std::uint32_t(page.partRows)});
        fields.push_back({.tag = tiff::TileOffsets, .list = &offsets});
        fields.push_back({.tag = tiff::TileByteCounts, .list = &sizes});
    }
    fields.push_back({.tag = tiff::SampleFormat, .value = std::uint32_t(sampleFormat(page.type))});
    return fields;
}

constexpr std::uint32_t headBytes = 8;
constexpr std::uint32_t entryBytes = 12;

bool appendParts(QByteArray& bytes, const ImagePage& page, std::vector<std::uint32_t>& offsets,
    std::vector<std::uint32_t>& sizes)
{
    QFile file(page.file);
    if (!file.open(QIODevice::ReadOnly))
        return false;
    for (const FileSpan& part : page.parts) {
        // Values of 16 bits and more are read from even places.
        bytes.append(bytes.size() % 2, '\0');
        offsets.push_back(std::uint32_t(bytes.size()));
        sizes.push_back(std::uint32_t(part.size));
        const QByteArray data =
            file.seek(qint64(part.begin)) ? file.read(qint64(part.size)) : QByteArray();
        if (std::uint64_t(data.size()) != part.size)
            return false;
        bytes.append(data);
    }
    bytes.append(bytes.size() % 2, '\0');
    return true;
}

} // namespace

QByteArray tiffOfPage(const ImagePage& page)
{
    QByteArray bytes(headBytes, '\0');
    std::vector<std::uint32_t> offsets;
    std::vector<std::uint32_t> sizes;
    if (!appendParts(bytes, page, offsets, sizes))
        return {};
    const std::vector<Field> fields = fieldsOf(page, offsets, sizes);
    const auto directory = std::uint32_t(bytes.size());
    std::uint32_t lists = directory + 2 + entryBytes * std::uint32_t(fields.size()) + 4;

    QByteArray behind;
    QDataStream entries(&bytes, QIODevice::WriteOnly | QIODevice::Append);
    QDataStream values(&behind, QIODevice::WriteOnly);
    const auto order = page.bigEndian ? QDataStream::BigEndian : QDataStream::LittleEndian;
    entries.setByteOrder(order);
    values.setByteOrder(order);
    entries << std::uint16_t(fields.size());
    for (const Field& field : fields) {
        // A list of one stands in the entry itself.
        const bool inPlace = field.list == nullptr || field.list->size() == 1;
        entries << std::uint16_t(field.tag) << std::uint16_t(tiff::Long)
                << std::uint32_t(field.list == nullptr ? 1 : field.list->size());
        if (inPlace) {
            entries << (field.list == nullptr ? field.value : field.list->front());
            continue;
        }
        entries << std::uint32_t(lists + std::uint32_t(behind.size()));
        for (const std::uint32_t value : *field.list)
            values << value;
    }
    entries << std::uint32_t(0);
    bytes.append(behind);

    QByteArray head;
    QDataStream begin(&head, QIODevice::WriteOnly);
    begin.setByteOrder(order);
    constexpr std::uint16_t version = 42;
    begin << std::uint16_t(page.bigEndian ? 0x4d4d : 0x4949) << version << directory;
    return bytes.replace(0, headBytes, head);
}

} // namespace core
