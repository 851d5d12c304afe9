// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/DicomFile.h"

#include "core/dicom/TransferSyntax.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace core {

namespace {

using Bytes = DicomFile::Bytes;

constexpr std::size_t openEnd = SIZE_MAX;
constexpr std::size_t maximumDepth = 64;
constexpr std::uint32_t undefinedLength = 0xffffffffu;
constexpr std::uint32_t itemTag = 0xfffee000u;
constexpr std::uint32_t itemEndTag = 0xfffee00du;
constexpr std::uint32_t sequenceEndTag = 0xfffee0ddu;
constexpr std::uint32_t pixelDataTag = 0x7fe00010u;

std::uint16_t read16(Bytes bytes, std::size_t at, bool bigEndian)
{
    return bigEndian ? std::uint16_t(bytes[at] << 8 | bytes[at + 1])
                     : std::uint16_t(bytes[at + 1] << 8 | bytes[at]);
}

std::uint32_t read32(Bytes bytes, std::size_t at, bool bigEndian)
{
    const std::uint32_t first = read16(bytes, at, bigEndian);
    const std::uint32_t second = read16(bytes, at + 2, bigEndian);
    return bigEndian ? first << 16 | second : second << 16 | first;
}

std::uint32_t readTag(Bytes bytes, std::size_t at, bool bigEndian)
{
    return std::uint32_t(read16(bytes, at, bigEndian)) << 16 | read16(bytes, at + 2, bigEndian);
}

QString tagText(std::uint32_t tag)
{
    return QStringLiteral("(%1,%2)")
        .arg(tag >> 16, 4, 16, QLatin1Char('0'))
        .arg(tag & 0xffff, 4, 16, QLatin1Char('0'));
}

bool isVr(const std::uint8_t* letters)
{
    return letters[0] >= 'A' && letters[0] <= 'Z' && letters[1] >= 'A' && letters[1] <= 'Z';
}

bool hasLongLength(std::string_view vr)
{
    constexpr std::array<std::string_view, 13> longOnes{
        "OB", "OD", "OF", "OL", "OV", "OW", "SQ", "SV", "UC", "UN", "UR", "UT", "UV"};
    return std::find(longOnes.begin(), longOnes.end(), vr) != longOnes.end();
}

struct Element {
    std::uint32_t tag = 0;
    std::string_view vr; ///< empty in implicit VR
    std::uint32_t length = 0;
    std::size_t value = 0; ///< where it begins
};

/// Reads the element that begins at @p at; false if its header does not fit into the bytes.
bool readElement(Bytes bytes, std::size_t at, bool explicitVr, bool bigEndian, Element& element)
{
    if (bytes.size() - at < 8)
        return false;
    element.tag = readTag(bytes, at, bigEndian);
    element.vr = {};
    element.value = at + 8;
    if (!explicitVr || element.tag >> 16 == 0xfffe) {
        element.length = read32(bytes, at + 4, bigEndian);
        return true;
    }
    element.vr = {reinterpret_cast<const char*>(bytes.data()) + at + 4, 2};
    if (hasLongLength(element.vr)) {
        if (bytes.size() - at < 12)
            return false;
        element.length = read32(bytes, at + 8, bigEndian);
        element.value = at + 12;
    } else if (isVr(bytes.data() + at + 4)) {
        element.length = read16(bytes, at + 6, bigEndian);
    } else {
        // No VR at all: an element that slipped in as implicit, as DCMTK takes it.
        element.vr = {};
        element.length = read32(bytes, at + 4, bigEndian);
    }
    return true;
}

/// 2.0 GiB out of 2 MB was measured: what a slice can need ends far below.
Result<QByteArray> inflateDataSet(Bytes deflated, const QString& path)
{
    constexpr std::size_t freeOutput = 64u << 20;
    constexpr std::size_t maximumRatio = 200;
    constexpr std::size_t maximumOutput = std::size_t(1) << 30;
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
        return failure(ErrorCode::OutOfMemory, path);
    stream.next_in = const_cast<Bytef*>(deflated.data());
    stream.avail_in = uInt(std::min<std::size_t>(deflated.size(), UINT32_MAX));
    QByteArray output;
    std::vector<Bytef> chunk(1 << 18);
    int state = Z_OK;
    bool tooLarge = false;
    while (state == Z_OK && !tooLarge) {
        stream.next_out = chunk.data();
        stream.avail_out = uInt(chunk.size());
        state = inflate(&stream, Z_NO_FLUSH);
        output.append(reinterpret_cast<const char*>(chunk.data()),
            qsizetype(chunk.size() - stream.avail_out));
        const auto size = std::size_t(output.size());
        tooLarge = size > maximumOutput
            || (size > freeOutput && size / maximumRatio > std::size_t(stream.total_in));
    }
    inflateEnd(&stream);
    if (tooLarge)
        return failure(ErrorCode::FileUnreadable, path,
            QStringLiteral("the deflated data grow beyond any sensible size"));
    if (state != Z_STREAM_END)
        return failure(ErrorCode::FileTruncated, path, QStringLiteral("damaged deflated data"));
    return output;
}

} // namespace

/// The iterative walk over the data set. One level of the stack is a sequence, an item or the data
/// set itself.
struct DicomFile::Walk {
    struct Level {
        std::size_t end = openEnd;
        bool isSequence = false;
        bool explicitVr = true;
        bool holdsFragments = false;
    };

    DicomFile& file;
    const QString& path;
    Bytes bytes;
    bool bigEndian = false;
    std::vector<Level> levels{};
    std::size_t at = 0;

    [[nodiscard]] tl::unexpected<Error> cut(std::uint32_t tag) const
    {
        return failure(ErrorCode::FileTruncated, path,
            QStringLiteral("element %1 goes beyond the end").arg(tagText(tag)));
    }
    [[nodiscard]] tl::unexpected<Error> damaged(const QString& why) const
    {
        return failure(ErrorCode::FileUnreadable, path, why);
    }

    Result<void> run(bool explicitVr)
    {
        levels.push_back({.end = bytes.size(), .explicitVr = explicitVr});
        while (true) {
            while (levels.size() > 1 && levels.back().end != openEnd && at >= levels.back().end)
                levels.pop_back();
            if (levels.size() > maximumDepth)
                return damaged(QStringLiteral("sequences are nested deeper than %1 levels")
                                   .arg(int(maximumDepth)));
            const bool outermost = levels.size() == 1;
            const Bytes rest = bytes.subspan(at);
            if (rest.size() < 8) {
                if (levels.size() > 1)
                    return failure(ErrorCode::FileTruncated, path,
                        QStringLiteral("it ends inside a sequence"));
                // Zero bytes behind the last element are padding.
                if (std::all_of(rest.begin(), rest.end(), [](auto byte) { return byte == 0; }))
                    return {};
                return failure(
                    ErrorCode::FileTruncated, path, QStringLiteral("it ends inside an element"));
            }
            Element element;
            if (!readElement(bytes, at, levels.back().explicitVr, bigEndian, element))
                return cut(element.tag);
            if (outermost && element.tag == pixelDataTag) {
                readPixels(element);
                return {};
            }
            // Nothing but padding begins like this.
            if (outermost && element.tag == 0)
                return {};
            const Result<void> entered =
                levels.back().isSequence ? enterItem(element) : enterElement(element);
            if (!entered)
                return entered;
        }
    }

    Result<void> enterItem(const Element& element)
    {
        const Level level = levels.back();
        if (element.tag == sequenceEndTag) {
            at = element.value;
            levels.pop_back();
            return {};
        }
        if (element.tag != itemTag) {
            // Writers that count an undefined sequence wrongly: what follows belongs to the parent.
            if (level.end != openEnd) {
                at = level.end;
                return {};
            }
            return damaged(
                QStringLiteral("a sequence holds %1 instead of an item").arg(tagText(element.tag)));
        }
        at = element.value;
        if (level.holdsFragments)
            return skip(element);
        if (element.length != undefinedLength && element.length > bytes.size() - at)
            return cut(element.tag);
        levels.push_back({.end = element.length == undefinedLength ? openEnd : at + element.length,
            .explicitVr = level.explicitVr});
        return {};
    }

    Result<void> enterElement(const Element& element)
    {
        at = element.value;
        if (element.tag == itemEndTag) {
            if (levels.size() > 1)
                levels.pop_back();
            return {};
        }
        const bool explicitVr = levels.back().explicitVr;
        if (element.length == undefinedLength) {
            // UN of undefined length is a sequence in implicit VR (PS3.5 6.2.2).
            levels.push_back({.isSequence = true,
                .explicitVr = explicitVr && element.vr != "UN",
                .holdsFragments = element.vr == "OB" || element.vr == "OW"});
            return {};
        }
        if (element.length > bytes.size() - at)
            return cut(element.tag);
        // Implicit VR does not say what is a sequence: whatever begins with an item is walked.
        const bool isSequence = element.vr == "SQ"
            || (element.vr.empty() && element.length >= 8
                && readTag(bytes, at, bigEndian) == itemTag);
        if (!isSequence)
            return skip(element);
        levels.push_back(
            {.end = at + element.length, .isSequence = true, .explicitVr = explicitVr});
        return {};
    }

    Result<void> skip(const Element& element)
    {
        if (element.length > bytes.size() - at)
            return cut(element.tag);
        at += element.length;
        return {};
    }

    void readPixels(const Element& element)
    {
        file.m_hasPixels = true;
        file.m_pixelsAreWords = element.vr != "OB";
        const Bytes rest = bytes.subspan(element.value);
        if (element.length != undefinedLength) {
            file.m_pixelsCut = element.length > rest.size();
            file.m_pixels = rest.first(std::min<std::size_t>(element.length, rest.size()));
            return;
        }
        file.m_encapsulated = true;
        bool isOffsetTable = true;
        std::size_t offset = 0;
        while (true) {
            // A missing end mark costs nothing where the fragments are whole.
            if (rest.size() - offset < 8) {
                file.m_pixelsCut = file.m_fragments.empty();
                return;
            }
            const std::uint32_t tag = readTag(rest, offset, false);
            const std::uint32_t length = read32(rest, offset + 4, false);
            offset += 8;
            if (tag != itemTag) {
                file.m_pixelsCut = file.m_fragments.empty();
                return;
            }
            if (length > rest.size() - offset) {
                file.m_pixelsCut = true;
                return;
            }
            if (!isOffsetTable)
                file.m_fragments.push_back(rest.subspan(offset, length));
            isOffsetTable = false;
            offset += length;
        }
    }
};

Result<DicomFile> DicomFile::open(const QString& path)
{
    DicomFile file;
    file.m_file = std::make_unique<QFile>(path);
    if (!file.m_file->open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, path, file.m_file->errorString());
    const auto size = std::size_t(file.m_file->size());
    const auto notDicom = [&] {
        return failure(
            ErrorCode::UnsupportedFormat, path, QStringLiteral("not a DICOM or NIfTI file"));
    };
    if (size == 0)
        return failure(ErrorCode::FileTruncated, path, QStringLiteral("it holds no bytes"));
    if (size < 16)
        return notDicom();
    const uchar* mapped = file.m_file->map(0, qint64(size));
    if (!mapped)
        return failure(ErrorCode::FileUnreadable, path, file.m_file->errorString());
    const Bytes bytes(mapped, size);

    std::size_t at = 0;
    const bool hasPreamble = size >= 132 && std::memcmp(mapped + 128, "DICM", 4) == 0;
    if (hasPreamble) {
        at = 132;
    } else {
        // Without preamble only a plausible beginning counts.
        const std::uint16_t group = read16(bytes, 0, false);
        const bool plausible = (group == 2 || group == 8) && read16(bytes, 2, false) < 0x1200
            && (isVr(mapped + 4) || read32(bytes, 4, false) < size);
        if (!plausible)
            return notDicom();
    }

    // File meta information: always explicit little endian (PS3.10 7.1).
    Element element;
    while (size - at >= 8 && read16(bytes, at, false) == 2) {
        if (!readElement(bytes, at, true, false, element)
            || element.length > size - element.value) {
            return failure(
                ErrorCode::FileTruncated, path, QStringLiteral("it ends inside its header"));
        }
        if (element.tag == 0x00020010u) {
            file.m_transferSyntaxUid = QString::fromLatin1(
                reinterpret_cast<const char*>(mapped) + element.value, qsizetype(element.length))
                                           .remove(QChar(0))
                                           .trimmed();
        }
        at = element.value + element.length;
    }
    if (file.m_transferSyntaxUid.isEmpty()) {
        const bool explicitVr = size - at >= 8 && isVr(mapped + at + 4);
        file.m_transferSyntaxUid = explicitVr ? QStringLiteral("1.2.840.10008.1.2.1")
                                              : QStringLiteral("1.2.840.10008.1.2");
    }
    const TransferSyntax& syntax = transferSyntax(file.m_transferSyntaxUid);
    file.m_bigEndian = syntax.bigEndian;

    Bytes dataSet = bytes.subspan(at);
    if (syntax.deflated) {
        Result<QByteArray> inflated = inflateDataSet(dataSet, path);
        if (!inflated)
            return tl::unexpected<Error>(inflated.error());
        file.m_inflated = std::move(*inflated);
        dataSet = Bytes(reinterpret_cast<const std::uint8_t*>(file.m_inflated.constData()),
            std::size_t(file.m_inflated.size()));
    }
    Walk walk{.file = file, .path = path, .bytes = dataSet, .bigEndian = syntax.bigEndian};
    if (const Result<void> walked = walk.run(syntax.explicitVr); !walked)
        return tl::unexpected<Error>(walked.error());
    return file;
}

} // namespace core
