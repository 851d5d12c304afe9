// SPDX-License-Identifier: Apache-2.0
#include "core/images/TiffDirectory.h"

#include "core/images/ImageSpacing.h"
#include "core/images/TiffEntries.h"
#include "core/images/TiffTags.h"

#include <QFile>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace core {

namespace {

/// What so many bytes unpack to at most.
double greatestRatio(int packing)
{
    switch (packing) {
    case tiff::None:
        return 1.0;
    case tiff::PackBits:
        return 64.0;
    case tiff::Lzw:
        // A code of 9 to 12 bits stands for 4096 bytes at most.
        return 3700.0;
    default:
        return 1040.0;
    }
}

/// A page may unpack to more than its parts, which are padded at the right and below.
constexpr std::uint64_t mostPageBytes = std::uint64_t(1) << 31;

std::optional<ScalarType> scalarType(std::uint64_t bits, std::uint64_t format)
{
    constexpr std::uint64_t isUnsigned = 1;
    constexpr std::uint64_t isSigned = 2;
    constexpr std::uint64_t isFloat = 3;
    const auto either = [&](ScalarType without, ScalarType with) -> std::optional<ScalarType> {
        if (format == isUnsigned)
            return without;
        return format == isSigned ? std::optional(with) : std::nullopt;
    };
    if (bits == 8)
        return either(ScalarType::UInt8, ScalarType::Int8);
    if (bits == 16)
        return either(ScalarType::UInt16, ScalarType::Int16);
    if (bits == 32 && format == isFloat)
        return ScalarType::Float32;
    if (bits == 32)
        return either(ScalarType::UInt32, ScalarType::Int32);
    return bits == 64 && format == isFloat ? std::optional(ScalarType::Float64) : std::nullopt;
}

/// One directory as a page.
class PageReader {
public:
    PageReader(TiffEntries& entries, QString path, std::uint64_t fileBytes)
        : m_entries(entries)
        , m_path(std::move(path))
        , m_fileBytes(fileBytes)
    {
    }

    Result<ImagePage> read()
    {
        m_page.file = m_path;
        m_page.form = ImagePage::Form::Tiff;
        m_page.bigEndian = m_entries.isBigEndian();
        for (const auto step : {&PageReader::setSize, &PageReader::setPixels,
                 &PageReader::setPacking, &PageReader::setParts}) {
            if (const Result<void> set = (this->*step)(); !set)
                return tl::unexpected<Error>(set.error());
        }
        setSpacing();
        m_page.isUpright = value(tiff::Orientation, 1) <= 1;
        return std::move(m_page);
    }

private:
    /// What is no number counts as a great one, which no field may have.
    [[nodiscard]] std::uint64_t value(int tag, std::uint64_t otherwise) const
    {
        return m_entries.number(tag, otherwise).value_or(std::numeric_limits<std::uint64_t>::max());
    }
    [[nodiscard]] tl::unexpected<Error> unsupported(const Clause& reason) const
    {
        return failure(ErrorCode::UnsupportedFormat, m_path, reason);
    }
    [[nodiscard]] tl::unexpected<Error> unsound(const Clause& what) const
    {
        return failure(
            ErrorCode::FileUnreadable, m_path, Clause::saying("its header does not name %1", what));
    }

    Result<void> setSize()
    {
        const std::uint64_t columns = value(tiff::ImageWidth, 0);
        const std::uint64_t rows = value(tiff::ImageLength, 0);
        const auto fits = [](std::uint64_t side) {
            return side >= 1 && side <= std::uint64_t(longestImageSide);
        };
        if (!fits(columns) || !fits(rows))
            return failure(ErrorCode::InvalidGeometry, m_path,
                Clause::saying("%1 × %2 pixels", columns, rows));
        m_page.columns = int(columns);
        m_page.rows = int(rows);
        return {};
    }

    Result<void> setPixels()
    {
        const std::uint64_t photometric = value(tiff::Photometric, 1);
        const std::uint64_t samples = value(tiff::SamplesPerPixel, 1);
        constexpr std::uint64_t palette = 3;
        if (photometric == palette)
            return unsupported(
                Clause::saying("its pixels are colours of a palette; pictures in grey are read"));
        if (photometric > palette || photometric == 2)
            return unsupported(Clause::saying("its pixels are colours; pictures in grey are read"));
        if (samples != 1)
            return unsupported(Clause::saying("it holds %1 values per pixel", samples));
        m_page.isInverted = photometric == 0;
        const std::uint64_t bits = value(tiff::BitsPerSample, 1);
        // Formats that say nothing of their numbers count as unsigned.
        constexpr std::uint64_t notSaid = 4;
        const std::uint64_t format = value(tiff::SampleFormat, 1);
        const auto type = scalarType(bits, format == notSaid ? 1 : format);
        if (!type)
            return unsupported(
                Clause::saying("its pixels have %1 bits (sample format %2); whole numbers of 8, "
                               "16 and 32 bits and floating-point ones of 32 and 64 are read",
                    bits, format));
        m_page.type = *type;
        return {};
    }

    Result<void> setPacking()
    {
        const std::uint64_t packing = value(tiff::Compression, tiff::None);
        const bool isPlain = packing == tiff::None || packing == tiff::PackBits;
        if (!isPlain && packing != tiff::Lzw && packing != tiff::Deflate
            && packing != tiff::OldDeflate)
            return unsupported(Clause::saying("its pixels are packed by method %1; PackBits, LZW "
                                              "and deflate are read",
                packing));
        if (value(tiff::FillOrder, 1) != 1)
            return unsupported(Clause::saying("its bits lie in reverse order"));
        m_page.compression = int(packing);
        const std::uint64_t predictor = isPlain ? 1 : value(tiff::Predictor, 1);
        const bool floats = isFloating(m_page.type);
        if (predictor != 1 && !(predictor == 2 && !floats) && !(predictor == 3 && floats))
            return unsupported(Clause::saying("its predictor is %1", predictor));
        m_page.predictor = int(predictor);
        return {};
    }

    Result<void> setParts()
    {
        m_page.isTiled = m_entries.has(tiff::TileWidth);
        const auto columns = std::uint64_t(m_page.columns);
        const auto rows = std::uint64_t(m_page.rows);
        const std::uint64_t wide = m_page.isTiled ? value(tiff::TileWidth, 0) : columns;
        const std::uint64_t high = m_page.isTiled ? value(tiff::TileLength, 0)
                                                  : std::min(value(tiff::RowsPerStrip, rows), rows);
        constexpr std::uint64_t most = longestImageSide;
        if (wide < 1 || high < 1 || wide > most || high > most
            || (m_page.isTiled && (wide % 16 != 0 || high % 16 != 0)))
            return unsound(m_page.isTiled ? Clause::saying("the size of its tiles")
                                          : Clause::saying("the height of its strips"));
        m_page.partColumns = int(wide);
        m_page.partRows = int(high);
        const std::uint64_t count = ((columns + wide - 1) / wide) * ((rows + high - 1) / high);
        const auto offsets =
            m_entries.numbers(m_page.isTiled ? tiff::TileOffsets : tiff::StripOffsets, count);
        const int countTag = m_page.isTiled ? tiff::TileByteCounts : tiff::StripByteCounts;
        auto sizes = m_entries.numbers(countTag, count);
        // Some write none where there is one strip that is not packed.
        if (!sizes && !m_entries.has(countTag) && count == 1 && m_page.compression == tiff::None)
            sizes = std::vector<std::uint64_t>{m_page.byteCount()};
        if (!offsets || !sizes)
            return unsound(Clause::saying("where its pixels lie"));
        return keepParts(*offsets, *sizes);
    }

    Result<void> keepParts(
        const std::vector<std::uint64_t>& offsets, const std::vector<std::uint64_t>& sizes)
    {
        const auto truncated = [&] {
            return failure(
                ErrorCode::FileTruncated, m_path, Clause::saying("its pixels are incomplete"));
        };
        const auto full = std::uint64_t(m_page.partColumns) * std::uint64_t(m_page.partRows)
            * bytesPerScalar(m_page.type);
        if (full > mostPageBytes)
            return failure(ErrorCode::InvalidGeometry, m_path,
                Clause::saying("strips or tiles of %1 bytes", full));
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            if (offsets[i] > m_fileBytes || sizes[i] > m_fileBytes - offsets[i] || sizes[i] == 0)
                return truncated();
            sum += sizes[i];
            if (sum > mostPageBytes)
                return unsupported(Clause::saying("more than 2 GB for one picture"));
            // Parts that lie over each other would be read once for each.
            if (sum > m_fileBytes)
                return unsound(Clause::saying("where its pixels lie"));
            m_page.parts.push_back({.begin = offsets[i], .size = sizes[i]});
        }
        const double ratio = greatestRatio(m_page.compression);
        // Those at the right and below may say less than they hold, none may say more.
        return double(sum) * ratio < double(m_page.byteCount()) ? truncated() : Result<void>();
    }

    void setSpacing()
    {
        const ImageJWords words = imageJWords(m_entries.text(tiff::ImageDescription));
        const double columns = m_entries.rational(tiff::XResolution);
        const double rows = m_entries.rational(tiff::YResolution);
        constexpr double millimetresPerCentimetre = 10.0;
        const std::uint64_t unit = value(tiff::ResolutionUnit, 2);
        double millimetres = 0.0;
        if (words.isImageJ)
            millimetres = words.millimetresPerUnit;
        else if (unit == 2)
            millimetres = millimetresPerInch;
        else if (unit == 3)
            millimetres = millimetresPerCentimetre;
        if (millimetres > 0.0)
            setResolution(m_page.spacingMm, columns, rows, millimetres);
        m_page.spacingMm.z = words.spacing * words.millimetresPerUnit;
    }

    TiffEntries& m_entries;
    const QString m_path;
    const std::uint64_t m_fileBytes;
    ImagePage m_page;
};

/// What ImageJ's words say of a file that its directories do not; empty if nothing.
Clause contradiction(const ImageJWords& words, std::size_t pages)
{
    if (words.perPlace > 1)
        return Clause::saying("it holds several channels or points in time at every place");
    // ImageJ writes what is larger than 4 GB without directories.
    return words.images > 1 && pages == 1
        ? Clause::saying("its header tells of %1 pictures but has one directory", words.images)
        : Clause();
}

} // namespace

bool isTiff(const QByteArray& begin)
{
    for (const char* order : {"II*", "MM", "II+"}) {
        const QByteArray orderMark = order;
        if (!begin.startsWith(orderMark))
            continue;
        if (orderMark != "MM")
            return begin.size() > 3 && begin[3] == 0;
        return begin.size() > 3 && begin[2] == 0 && (begin[3] == 42 || begin[3] == 43);
    }
    return false;
}

Result<std::vector<ImagePage>> readTiffPages(QFile& file)
{
    TiffEntries entries(file);
    const auto fileBytes = std::uint64_t(file.size());
    std::vector<ImagePage> pages;
    ImageJWords words;
    while (entries.next()) {
        constexpr std::uint64_t reduced = 1;
        if ((entries.number(tiff::NewSubfileType, 0).value_or(0) & reduced) != 0)
            continue;
        Result<ImagePage> page = PageReader(entries, file.fileName(), fileBytes).read();
        if (!page)
            return tl::unexpected<Error>(page.error());
        if (pages.empty())
            words = imageJWords(entries.text(tiff::ImageDescription));
        pages.push_back(*std::move(page));
    }
    if (!entries.reason().isEmpty())
        return failure(ErrorCode::FileUnreadable, file.fileName(), entries.reason());
    if (pages.empty())
        return failure(ErrorCode::UnsupportedFormat, file.fileName(),
            Clause::saying("it holds small pictures for lists only"));
    if (const Clause wrong = contradiction(words, pages.size()); !wrong.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, file.fileName(), wrong);
    return pages;
}

} // namespace core
