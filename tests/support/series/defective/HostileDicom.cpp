// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/defective/HostileDicom.h"

#include <zlib.h>

#include <string_view>

namespace test {

namespace {

constexpr const char* implicitLittle = "1.2.840.10008.1.2";
constexpr const char* explicitLittle = "1.2.840.10008.1.2.1";
constexpr const char* deflatedLittle = "1.2.840.10008.1.2.1.99";
constexpr const char* explicitBig = "1.2.840.10008.1.2.2";
constexpr const char* rle = "1.2.840.10008.1.2.5";
constexpr const char* jpeg = "1.2.840.10008.1.2.4.70";
constexpr const char* jpeg2000 = "1.2.840.10008.1.2.4.90";
constexpr int deep = 100'000;

QByteArray number(std::uint32_t value, int bytes, bool bigEndian = false)
{
    QByteArray all;
    for (int i = 0; i < bytes; ++i)
        all.append(char(value >> 8 * (bigEndian ? bytes - 1 - i : i)));
    return all;
}

QByteArray tagBytes(std::uint32_t tag, bool bigEndian = false)
{
    return number(tag >> 16, 2, bigEndian) + number(tag & 0xffff, 2, bigEndian);
}

QByteArray implicitElement(std::uint32_t tag, const QByteArray& value)
{
    return tagBytes(tag) + number(std::uint32_t(value.size()), 4) + value;
}

QByteArray dicomFile(const char* syntax, const QByteArray& dataSet)
{
    const QByteArray meta = explicitElement(0x00020002, "UI", "1.2.840.10008.5.1.4.1.1.2")
        + explicitElement(0x00020010, "UI", syntax);
    return QByteArray(128, '\0') + "DICM"
        + explicitElement(0x00020000, "UL", words({std::uint32_t(meta.size())})) + meta + dataSet;
}

QByteArray openSequence(const char* vr = "SQ")
{
    return tagBytes(0x00081115) + vr + number(0, 2) + words({0xffffffffu});
}

QByteArray openItem()
{
    return tagBytes(0xfffee000u) + words({0xffffffffu});
}

QByteArray nest(int levels)
{
    return (openSequence() + openItem()).repeated(levels);
}

QByteArray implicitNest(int levels)
{
    return (tagBytes(0x00081115) + words({0xffffffffu}) + openItem()).repeated(levels);
}

QByteArray deflated(const QByteArray& head, std::uint64_t zeros)
{
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
    QByteArray output;
    QByteArray chunk(1 << 16, '\0');
    const auto feed = [&](const QByteArray& bytes, int flush) {
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.constData()));
        stream.avail_in = uInt(bytes.size());
        do {
            stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
            stream.avail_out = uInt(chunk.size());
            deflate(&stream, flush);
            output.append(chunk.constData(), chunk.size() - qsizetype(stream.avail_out));
        } while (stream.avail_out == 0);
    };
    feed(head, Z_NO_FLUSH);
    const QByteArray block(1 << 20, '\0');
    for (std::uint64_t done = 0; done < zeros; done += std::uint64_t(block.size()))
        feed(block, Z_NO_FLUSH);
    feed({}, Z_FINISH);
    deflateEnd(&stream);
    return output;
}

QByteArray imageElements(int rows, int columns, int bits = 16)
{
    return explicitElement(0x00280002, "US", number(1, 2))
        + explicitElement(0x00280004, "CS", "MONOCHROME2 ")
        + explicitElement(0x00280010, "US", number(std::uint32_t(rows), 2))
        + explicitElement(0x00280011, "US", number(std::uint32_t(columns), 2))
        + explicitElement(0x00280100, "US", number(std::uint32_t(bits), 2))
        + explicitElement(0x00280101, "US", number(std::uint32_t(bits), 2))
        + explicitElement(0x00280102, "US", number(std::uint32_t(bits - 1), 2))
        + explicitElement(0x00280103, "US", number(0, 2));
}

QByteArray withValue(QByteArray bytes, std::uint32_t tag, std::uint32_t value)
{
    const qsizetype at = bytes.indexOf(tagBytes(tag) + "US");
    bytes.replace(at + 8, 2, number(value, 2));
    return bytes;
}

QByteArray rleFile(int rows, int columns, const QByteArray& frame)
{
    return dicomFile(rle, imageElements(rows, columns) + encapsulated({{}, frame}));
}

QByteArray rleHeader(std::initializer_list<std::uint32_t> values)
{
    QByteArray header = words(values);
    return header.append(64 - header.size(), '\0');
}

/// An honest image with another frame in another syntax.
QByteArray withFrame(const QByteArray& honest, const char* syntax, const QByteArray& frame)
{
    constexpr qsizetype metaAt = 144; // behind preamble, mark and the length of what follows
    const auto byte = [&](qsizetype at) { return std::uint32_t(std::uint8_t(honest[at])); };
    const qsizetype begin = metaAt + qsizetype(byte(140) | byte(141) << 8);
    const qsizetype end = honest.lastIndexOf(tagBytes(0x7fe00010u));
    return dicomFile(syntax, honest.mid(begin, end - begin) + encapsulated({QByteArray(), frame}));
}

/// A JPEG 2000 header for 16 × 12 pixels of one component, in tiles of this size (ITU-T T.800 A.5).
QByteArray jpeg2000Header(std::uint32_t tile, std::uint32_t columns = 16)
{
    const auto big = [](std::uint32_t value, int bytes) { return number(value, bytes, true); };
    QByteArray all = QByteArray::fromHex("ff4fff51") + big(41, 2) + big(0, 2);
    for (const std::uint32_t value : {columns, 12u, 0u, 0u, tile, tile, 0u, 0u})
        all += big(value, 4);
    all += big(1, 2) + QByteArray::fromHex("0f0101");
    all += QByteArray::fromHex("ff52000c00000001000504040001"); // COD: five levels, blocks of 64²
    return all + QByteArray::fromHex("ff5c00134080889090989898a0a0a0a8a8a8b0b0b0"); // QCD
}

QByteArray unsorted(int count)
{
    QByteArray all;
    for (int i = count; i > 0; --i)
        all += tagBytes(0x00090000u + std::uint32_t(i)) + words({0});
    return all;
}

} // namespace

QByteArray explicitElement(std::uint32_t tag, const char* vr, const QByteArray& value)
{
    QByteArray even = value;
    if (even.size() % 2 != 0)
        even.append('\0');
    const std::string_view name(vr);
    const bool isLong = name == "OB" || name == "OW" || name == "SQ" || name == "UN";
    return tagBytes(tag) + vr
        + (isLong ? number(0, 2) + words({std::uint32_t(even.size())})
                  : number(std::uint32_t(even.size()), 2))
        + even;
}

QByteArray encapsulated(const std::vector<QByteArray>& fragments)
{
    QByteArray all = tagBytes(0x7fe00010u) + "OB" + number(0, 2) + words({0xffffffffu});
    for (const QByteArray& fragment : fragments)
        all += tagBytes(0xfffee000u) + words({std::uint32_t(fragment.size())}) + fragment;
    return all + tagBytes(0xfffee0ddu) + words({0});
}

QByteArray words(std::initializer_list<std::uint32_t> values)
{
    QByteArray all;
    for (const std::uint32_t value : values)
        all += number(value, 4);
    return all;
}

QByteArray deflatedBomb(int rows, int columns)
{
    const QByteArray head = imageElements(rows, columns) + tagBytes(0x7fe00010u) + "OW"
        + number(0, 2) + words({2u << 30});
    return dicomFile(deflatedLittle, deflated(head, std::uint64_t(256) << 20));
}

std::vector<HostileDicom> hostileDicoms(const QByteArray& honest)
{
    const QByteArray huge = tagBytes(0x7fe00010u) + "OW" + number(0, 2) + words({0xfffffff0u});
    const QByteArray secret = tagBytes(0x00091001u) + "OB" + number(0, 2) + words({1u << 30});
    const QByteArray large = withValue(withValue(honest, 0x00280010, 65535), 0x00280011, 65535);
    const char* const damagedRle = "damaged RLE data";
    const QByteArray startOfTile = QByteArray::fromHex("ff90000a0000ffffffff0001ff93");
    return {
        {"nest of 1000", dicomFile(explicitLittle, nest(1000)), "nested"},
        {"nest of 20000", dicomFile(explicitLittle, nest(20'000)), "nested"},
        {"nest of 200000", dicomFile(explicitLittle, nest(200'000)), "nested"},
        {"implicit nest", dicomFile(implicitLittle, implicitNest(deep)), "nested"},
        {"deflated nest", dicomFile(deflatedLittle, deflated(nest(deep), 0)), "nested"},
        {"bomb in the pixel data", deflatedBomb(64, 0), "an image of 0 × 64 pixels"},
        {"bomb in the header",
            dicomFile(deflatedLittle, deflated(secret, std::uint64_t(128) << 20)), "grow beyond"},
        {"huge length of pixel data", dicomFile(explicitLittle, huge + "abcd"), "an image of 0"},
        {"huge length in the header",
            dicomFile(explicitLittle,
                tagBytes(0x00091001u) + "OB" + number(0, 2) + words({0xfffffff0u}) + "abcd"),
            "(0009,1001) goes beyond the end"},
        {"huge image", large, "too large"},
        {"huge image in RLE", rleFile(46341, 46341, rleHeader({2, 64, 66}) + "\xff\1\xff\1"),
            "too large"},
        {"image that no RLE data can hold",
            rleFile(20000, 20000, rleHeader({2, 64, 66}) + "\xff\1\xff\1"), damagedRle},
        {"RLE without a header", rleFile(12, 16, words({2, 64})), damagedRle},
        {"RLE segments beyond the end",
            rleFile(12, 16, rleHeader({2, 0x7ffffff0u, 0x7fffffffu}) + QByteArray(400, '\1')),
            damagedRle},
        {"RLE segments that run backwards",
            rleFile(12, 16, rleHeader({2, 300, 64}) + QByteArray(400, '\1')), damagedRle},
        {"too many elements",
            dicomFile(implicitLittle, (tagBytes(0x00090010u) + words({0})).repeated(2'100'000)),
            "more than 2000000 elements"},
        {"elements in no order", dicomFile(implicitLittle, unsorted(60'000)), "no order"},
        {"empty bytes without end", dicomFile(explicitLittle, QByteArray(2 << 20, '\0')),
            "empty bytes"},
        {"JPEG of markers that hang DCMTK",
            withFrame(honest, jpeg,
                QByteArray::fromHex("ffd8") + QByteArray::fromHex("ff01").repeated(500)),
            "damaged JPEG data", true},
        {"JPEG of gigabytes in a few bytes",
            withFrame(withValue(withValue(honest, 0x00280010, 32000), 0x00280011, 32000), jpeg,
                QByteArray::fromHex("ffd8ffc3000b107d007d0001011100ffd9")),
            "cannot hold"},
        {"JPEG 2000 in tiles that are not there",
            withFrame(honest, jpeg2000, jpeg2000Header(1) + startOfTile), "JPEG 2000", true},
        {"JPEG 2000 whose tile is noise",
            withFrame(
                honest, jpeg2000, jpeg2000Header(16) + startOfTile + QByteArray(3000, '\x5a')),
            "JPEG 2000", true},
        {"JPEG 2000 of another size",
            withFrame(honest, jpeg2000, jpeg2000Header(0x7fffffffu, 0x7fffffffu) + startOfTile),
            "JPEG 2000", true},
        {"cut pixel data", honest.left(honest.size() - 100), "pixel data are incomplete", true},
    };
}

std::vector<HostileDicom> hiddenNests()
{
    const QByteArray inside = nest(deep);
    const std::uint32_t length = std::uint32_t(inside.size());
    // Two bytes that are no letters and a length: as 32 bits it would skip the nest.
    const QByteArray noType =
        tagBytes(0x00080008) + QByteArray("\1\2", 2) + number((length + 0x20000) >> 16, 2);
    const QByteArray filler(qsizetype((length + 0x20000) >> 16), ' ');
    QByteArray big = tagBytes(0x00081115, true) + "UN" + number(0, 2) + words({0xffffffffu});
    big += (openItem() + tagBytes(0x00081115) + words({0xffffffffu})).repeated(deep);
    const QByteArray shownFirst = explicitElement(0x00080008, "CS", "ORIGINAL");
    const auto withMeta = [&](std::uint32_t groupLength, const QByteArray& more,
                              const QByteArray& dataSet) {
        return QByteArray(128, '\0') + "DICM"
            + explicitElement(0x00020000, "UL", words({groupLength}))
            + explicitElement(0x00020010, "UI", implicitLittle) + more + dataSet;
    };
    return {
        {"behind empty bytes", dicomFile(explicitLittle, shownFirst + QByteArray(8, '\0') + inside),
            "empty bytes"},
        {"behind an element without type",
            dicomFile(explicitLittle, shownFirst + noType + filler + inside), "nested"},
        {"behind an element of unknown type",
            dicomFile(explicitLittle,
                shownFirst + tagBytes(0x00080009) + "ZZ" + number(0xfff0, 2) + words({0})
                    + nest(3000)),
            "nested"},
        {"behind small letters",
            dicomFile(
                explicitLittle, shownFirst + tagBytes(0x00080009) + "ox" + number(0, 2) + inside),
            "no type"},
        {"little endian inside big endian", dicomFile(explicitBig, big), "nested"},
        {"in a private syntax", dicomFile("1.2.840.113619.5.2", implicitNest(deep)), "nested"},
        {"behind the pixel data",
            dicomFile(explicitLittle,
                imageElements(1, 1) + explicitElement(0x7fe00010u, "OW", "ab") + inside),
            ""},
        {"in the file meta information",
            withMeta(length + 12, explicitElement(0x00020099, "SQ", inside), {}), ""},
        {"in file meta information that is longer than it",
            withMeta(length + 200, {}, implicitElement(0x00080008, inside)), ""},
    };
}

QByteArray randomDataSet(std::mt19937& random, bool explicitVr)
{
    const auto pick = [&](std::uint32_t count) { return std::uint32_t(random() % count); };
    const QByteArray endOfItem = tagBytes(0xfffee00du) + words({0});
    const QByteArray endOfSequence = tagBytes(0xfffee0ddu) + words({0});
    // Some stay flat, some go past the bound; half of them are sound.
    const std::uint32_t openings = 2 + pick(8);
    const bool noisy = pick(2) == 0;
    std::vector<bool> explicitLevels{explicitVr};
    QByteArray all;
    for (std::uint32_t i = 20 + pick(200); i > 0; --i) {
        const std::uint32_t tag = (pick(4) == 0 ? 0x00091001u : 0x00081115u) + pick(3);
        const bool isExplicit = explicitLevels.back();
        if (pick(12) < openings) {
            const bool unknown = pick(4) == 0;
            all += tagBytes(tag);
            if (isExplicit)
                all += (unknown ? "UN" : "SQ") + number(0, 2);
            all += words({0xffffffffu}) + openItem();
            explicitLevels.push_back(isExplicit && !unknown);
        } else if (pick(4) == 0 && explicitLevels.size() > 1) {
            all += endOfItem + endOfSequence;
            explicitLevels.pop_back();
        } else if (noisy && pick(30) == 0) {
            const QByteArray noise[] = {endOfItem, endOfSequence, QByteArray(8, '\0'), openItem(),
                tagBytes(tag) + "ZZ" + number(pick(3), 2) + words({pick(30)}),
                tagBytes(tag) + number(pick(3), 2) + number(pick(30), 2),
                QByteArray(qsizetype(pick(20)), char(random()))};
            all += noise[pick(7)];
        } else {
            all += isExplicit ? explicitElement(tag, "UN", QByteArray(4, 'x'))
                              : implicitElement(tag, QByteArray(4, 'x'));
        }
    }
    for (; explicitLevels.size() > 1; explicitLevels.pop_back())
        all += endOfItem + endOfSequence;
    return all;
}

} // namespace test
