// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/Preflight.h"

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace core {

namespace {

constexpr std::size_t openEnd = SIZE_MAX;
constexpr std::size_t maximumDepth = 64;
/// DCMTK holds some hundred bytes for each.
constexpr std::uint64_t maximumElements = 2'000'000;
/// Steps through lists that DCMTK would do to put unsorted elements into their places.
constexpr std::uint64_t maximumSorting = 200'000'000;
constexpr std::uint64_t maximumFrameBytes = std::uint64_t(1) << 31;
constexpr std::uint64_t maximumImageBytes = std::uint64_t(1) << 40;
constexpr std::uint64_t maximumFragments = 4'000'000;
constexpr std::size_t maximumPadding = 1 << 20;

/// One level of the stack: a sequence, an item or the data set itself.
struct Level {
    std::size_t end = openEnd;
    bool isSequence = false;
    bool holdsFragments = false;
    DataSetForm form{};
    std::uint32_t highestTag = 0;
    std::uint32_t elements = 0;
    std::uint32_t privateCreators = 0;
};

class Walk {
public:
    Walk(DicomBytes bytes, const DataSetForm& form, const QString& path)
        : m_bytes(bytes)
        , m_path(path)
    {
        m_levels.push_back({.end = bytes.size(), .form = form});
    }

    Result<PreflightFacts> run()
    {
        while (true) {
            leaveFullLevels();
            if (m_levels.size() > maximumDepth)
                return damaged(Clause::saying(
                    "sequences are nested deeper than %1 levels", int(maximumDepth)));
            if (m_bytes.size() - m_at < 8)
                return ended();
            DicomElement element;
            if (!readElement(m_bytes, m_at, m_levels.back().form, element))
                return cut(element.tag);
            if (isOutermost() && isPixelData(element.tag))
                return withPixels(element);
            if (isOutermost() && element.tag == 0)
                return padded();
            const Result<void> entered =
                m_levels.back().isSequence ? enterItem(element) : enterElement(element);
            if (!entered)
                return tl::unexpected<Error>(entered.error());
        }
    }

private:
    [[nodiscard]] bool isOutermost() const { return m_levels.size() == 1; }
    [[nodiscard]] std::size_t left() const { return m_bytes.size() - m_at; }

    [[nodiscard]] tl::unexpected<Error> cut(std::uint32_t tag) const
    {
        return failure(ErrorCode::FileTruncated, m_path,
            Clause::saying("element %1 goes beyond the end", tagText(tag)));
    }
    [[nodiscard]] tl::unexpected<Error> damaged(const Clause& why) const
    {
        return failure(ErrorCode::FileUnreadable, m_path, why);
    }

    [[nodiscard]] static bool isPixelData(std::uint32_t tag)
    {
        return tag == dicom_tag::pixelData || tag == dicom_tag::floatPixelData
            || tag == dicom_tag::doublePixelData;
    }

    void leaveFullLevels()
    {
        while (!isOutermost() && m_levels.back().end != openEnd && m_at >= m_levels.back().end)
            m_levels.pop_back();
    }

    [[nodiscard]] Result<PreflightFacts> ended()
    {
        if (!isOutermost()) {
            return failure(
                ErrorCode::FileTruncated, m_path, Clause::saying("it ends inside a sequence"));
        }
        // Zero bytes behind the last element are padding.
        const DicomBytes rest = m_bytes.subspan(m_at);
        if (!std::all_of(rest.begin(), rest.end(), [](auto byte) { return byte == 0; })) {
            return failure(
                ErrorCode::FileTruncated, m_path, Clause::saying("it ends inside an element"));
        }
        return m_facts;
    }

    /// Longer padding is no padding, and what follows it would be parsed by DCMTK unseen.
    [[nodiscard]] Result<PreflightFacts> padded()
    {
        const DicomBytes rest = m_bytes.subspan(m_at);
        const bool empty = rest.size() <= maximumPadding
            && std::all_of(rest.begin(), rest.end(), [](auto byte) { return byte == 0; });
        if (!empty)
            return damaged(Clause::saying("its header holds empty bytes where elements belong"));
        return m_facts;
    }

    Result<void> enterItem(const DicomElement& element)
    {
        const Level level = m_levels.back();
        if (element.tag == dicom_tag::sequenceEnd) {
            m_at = element.value;
            m_levels.pop_back();
            return {};
        }
        if (element.tag != dicom_tag::item) {
            // Writers that count a sequence wrongly: what follows belongs to the parent.
            if (level.end != openEnd) {
                m_at = level.end;
                return {};
            }
            return damaged(
                Clause::saying("a sequence holds %1 instead of an item", tagText(element.tag)));
        }
        if (const Result<void> few = count(); !few)
            return few;
        m_at = element.value;
        if (level.holdsFragments)
            return skip(element);
        if (element.length != undefinedLength && element.length > left())
            return cut(element.tag);
        m_levels.push_back(
            {.end = element.length == undefinedLength ? openEnd : m_at + element.length,
                .form = level.form});
        return {};
    }

    Result<void> enterElement(const DicomElement& element)
    {
        m_at = element.value;
        if (element.tag == dicom_tag::itemEnd) {
            if (!isOutermost())
                m_levels.pop_back();
            return {};
        }
        if (const Result<void> few = count(); !few)
            return few;
        if (const Result<void> quick = sort(element); !quick)
            return quick;
        const DataSetForm form = m_levels.back().form;
        // Small letters name no VR, but DCMTK has names of its own among them.
        const auto isSmall = [](char letter) { return letter >= 'a' && letter <= 'z'; };
        if (std::any_of(element.vr.begin(), element.vr.end(), isSmall))
            return damaged(Clause::saying("element %1 has no type", tagText(element.tag)));
        if (element.length == undefinedLength) {
            // UN of undefined length is a sequence in implicit VR little endian (PS3.5 6.2.2).
            const bool unknown = element.vr == "UN";
            m_levels.push_back({.isSequence = true,
                .holdsFragments = element.vr == "OB" || element.vr == "OW",
                .form = unknown ? DataSetForm{.explicitVr = false} : form});
            return {};
        }
        if (element.length > left())
            return cut(element.tag);
        // Implicit VR does not say what is a sequence: whatever begins with an item is walked.
        const bool isSequence = element.vr == "SQ"
            || (element.vr.empty() && element.length >= 8
                && readTag(m_bytes, m_at, form.bigEndian) == dicom_tag::item);
        if (isSequence) {
            m_levels.push_back({.end = m_at + element.length, .isSequence = true, .form = form});
            return {};
        }
        if (isOutermost())
            note(element);
        return skip(element);
    }

    Result<void> skip(const DicomElement& element)
    {
        if (element.length > left())
            return cut(element.tag);
        m_at += element.length;
        return {};
    }

    Result<void> count()
    {
        if (++m_elements <= maximumElements)
            return {};
        return damaged(Clause::saying("its header has more than %1 elements", maximumElements));
    }

    /// DCMTK keeps elements in a sorted list, which it searches from the back, and the owners of
    /// private ones in another, which it searches for each of those.
    Result<void> sort(const DicomElement& element)
    {
        Level& level = m_levels.back();
        if (element.tag < level.highestTag)
            m_sorting += level.elements;
        level.highestTag = std::max(level.highestTag, element.tag);
        ++level.elements;
        if (element.isPrivate() && (element.tag & 0xffffU) < 0x100)
            ++level.privateCreators;
        else if (element.isPrivate())
            m_sorting += level.privateCreators;
        if (m_sorting <= maximumSorting)
            return {};
        return damaged(Clause::saying("the elements of its header are in no order"));
    }

    /// Keeps what promises the size of the image. The first of two counts, as for DCMTK.
    void note(const DicomElement& element)
    {
        const bool isShort = element.length == 2;
        PromisedImage& image = m_facts.image;
        const auto number = [&] {
            return std::uint32_t(
                readUint16(m_bytes, element.value, m_levels.back().form.bigEndian));
        };
        if (isShort && element.tag == 0x00280002u)
            image.samplesPerPixel = number();
        else if (isShort && element.tag == 0x00280010u && image.rows == 0)
            image.rows = number();
        else if (isShort && element.tag == 0x00280011u && image.columns == 0)
            image.columns = number();
        else if (isShort && element.tag == 0x00280100u && image.bitsAllocated == 0)
            image.bitsAllocated = number();
        else if (element.tag == 0x00280008u)
            noteFrames(element);
    }

    void noteFrames(const DicomElement& element)
    {
        const char* begin = reinterpret_cast<const char*>(m_bytes.data()) + element.value;
        // An integer string has at most twelve characters (PS3.5 6.2).
        const char* end = begin + std::min<std::size_t>(element.length, 16);
        while (begin != end && (*begin == ' ' || *begin == '+'))
            ++begin;
        std::uint64_t frames = 0;
        if (std::from_chars(begin, end, frames).ec == std::errc() && frames > 0)
            m_facts.image.frames = frames;
    }

    [[nodiscard]] Result<PreflightFacts> withPixels(const DicomElement& element)
    {
        const PromisedImage& image = m_facts.image;
        const std::optional<std::uint64_t> all = image.bytes();
        if (image.frameBytes() > maximumFrameBytes || !all || *all > maximumImageBytes) {
            return damaged(Clause::saying("an image of %1 × %2 pixels in %3 frames is too large",
                image.columns, image.rows, image.frames));
        }
        m_facts.hasPixels = true;
        if (element.tag != dicom_tag::pixelData)
            m_facts.floatBits = element.tag == dicom_tag::floatPixelData ? 32 : 64;
        m_facts.pixelsAreWords = element.vr != "OB";
        m_facts.pixelsEncapsulated = element.length == undefinedLength;
        m_at = element.value;
        if (m_facts.pixelsEncapsulated)
            return withFragments();
        m_facts.pixels = {.at = m_at, .size = element.length};
        m_facts.pixelsCut = element.length > left();
        return m_facts;
    }

    /// Fragments are always little endian (PS3.5 A.4).
    [[nodiscard]] Result<PreflightFacts> withFragments()
    {
        ByteRange table;
        bool isOffsetTable = true;
        // A missing end mark costs nothing where the fragments are whole.
        while (left() >= 8 && readTag(m_bytes, m_at, false) == dicom_tag::item) {
            const std::size_t length = readUint32(m_bytes, m_at + 4, false);
            m_at += 8;
            if (length > left()) {
                m_facts.pixelsCut = true;
                break;
            }
            if (isOffsetTable)
                table = {.at = m_at, .size = length};
            else
                m_facts.fragments.push_back({.at = m_at, .size = length});
            isOffsetTable = false;
            m_at += length;
            if (m_facts.fragments.size() > maximumFragments)
                return damaged(Clause::saying("its pixel data are in too many pieces"));
        }
        m_facts.pixelsCut = m_facts.pixelsCut || m_facts.fragments.empty();
        m_facts.offsetTableSound = isSound(table);
        return m_facts;
    }

    [[nodiscard]] bool isSound(const ByteRange& table) const
    {
        if (table.size % 4 != 0)
            return false;
        if (m_facts.fragments.empty())
            return table.size == 0;
        const std::size_t origin = m_facts.fragments.front().at;
        auto fragment = m_facts.fragments.begin();
        for (std::size_t entry = 0; entry < table.size; entry += 4) {
            const std::size_t at = origin + readUint32(m_bytes, table.at + entry, false);
            while (fragment != m_facts.fragments.end() && fragment->at < at)
                ++fragment;
            if (fragment == m_facts.fragments.end() || fragment->at != at)
                return false;
        }
        return true;
    }

    DicomBytes m_bytes;
    const QString& m_path;
    PreflightFacts m_facts{};
    std::vector<Level> m_levels{};
    std::size_t m_at = 0;
    std::uint64_t m_elements = 0;
    std::uint64_t m_sorting = 0;
};

} // namespace

std::uint64_t PromisedImage::frameBytes() const
{
    // Four numbers of sixteen bits each.
    const std::uint64_t bits = std::uint64_t(columns & 0xffffU) * (rows & 0xffffU)
        * (samplesPerPixel & 0xffffU) * (bitsAllocated & 0xffffU);
    return bits / 8 + (bits % 8 != 0 ? 1 : 0);
}

std::optional<std::uint64_t> PromisedImage::bytes() const
{
    std::uint64_t product = 0;
    if (__builtin_mul_overflow(frameBytes(), frames, &product))
        return std::nullopt;
    return product;
}

Result<PreflightFacts> preflight(DicomBytes dataSet, const DataSetForm& form, const QString& path)
{
    return Walk(dataSet, form, path).run();
}

} // namespace core
