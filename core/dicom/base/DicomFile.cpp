// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/DicomFile.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/dicom/base/Rle.h"
#include "core/dicom/base/TransferSyntax.h"

#include <QFileInfo>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcistrmf.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace core {

namespace {

QString uidText(DicomBytes bytes, const DicomElement& element)
{
    return QString::fromLatin1(
        reinterpret_cast<const char*>(bytes.data()) + element.value, qsizetype(element.length))
        .remove(QChar(0))
        .trimmed();
}

tl::unexpected<Error> notDicom(const QString& path)
{
    return failure(ErrorCode::UnsupportedFormat, path, ofNoKnownFormat());
}

} // namespace

Clause ofNoKnownFormat()
{
    return Clause::saying("not a DICOM, NIfTI, NRRD, MetaImage, PNG or TIFF file");
}

Result<DicomFile> DicomFile::open(const QString& path)
{
    return openTo(Extent::Header, path);
}

Result<DicomFile> DicomFile::openWithPixels(const QString& path)
{
    return openTo(Extent::Pixels, path);
}

Result<DicomFile> DicomFile::openTo(Extent extent, const QString& path)
{
    DicomFile file;
    file.m_path = path;
    file.m_file = std::make_unique<QFile>(path);
    if (!file.m_file->open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, path, file.m_file->errorString());
    const auto size = std::size_t(file.m_file->size());
    if (size == 0)
        return failure(ErrorCode::FileTruncated, path, Clause::saying("it holds no bytes"));
    if (size < 16)
        return notDicom(path);
    const uchar* mapped = file.m_file->map(0, qint64(size));
    if (!mapped)
        return failure(ErrorCode::FileUnreadable, path, file.m_file->errorString());
    const Bytes bytes(mapped, size);
    if (const Result<void> read = file.readMetaHeader(bytes); !read)
        return tl::unexpected<Error>(read.error());
    file.m_dataSet = bytes.subspan(file.m_dataSetAt);
    const TransferSyntax& syntax = transferSyntax(file.m_transferSyntaxUid);
    file.m_form = {.explicitVr = syntax.explicitVr, .bigEndian = syntax.bigEndian};
    if (syntax.deflated)
        file.m_inflater = std::make_unique<Inflater>(file.m_dataSet);
    else
        file.chooseForm();
    const Result<void> checked = file.m_inflater ? file.checkDeflated(extent) : file.checkPlain();
    if (!checked)
        return tl::unexpected<Error>(checked.error());
    const Result<void> sound =
        syntax.coding == PixelCoding::Rle ? file.checkRle() : file.checkCompression();
    if (!sound)
        return tl::unexpected<Error>(sound.error());
    return file;
}

/// File meta information is always explicit little endian (PS3.10 7.1).
Result<void> DicomFile::readMetaHeader(Bytes bytes)
{
    const bool hasPreamble = bytes.size() >= 132 && std::memcmp(bytes.data() + 128, "DICM", 4) == 0;
    if (!hasPreamble) {
        // Without preamble only a plausible beginning counts.
        const std::uint16_t group = readUint16(bytes, 0, false);
        const bool plausible = (group == 2 || group == 8) && readUint16(bytes, 2, false) < 0x1200
            && (looksLikeVr(bytes, 4) || readUint32(bytes, 4, false) < bytes.size());
        if (!plausible)
            return notDicom(m_path);
    }
    std::size_t at = hasPreamble ? 132 : 0;
    DicomElement element;
    while (bytes.size() - at >= 8 && readUint16(bytes, at, false) == 2) {
        if (!readElement(bytes, at, {}, element) || element.length > bytes.size() - element.value) {
            return failure(
                ErrorCode::FileTruncated, m_path, Clause::saying("it ends inside its header"));
        }
        if (element.tag == 0x00020010u)
            m_transferSyntaxUid = uidText(bytes, element);
        else if (element.tag == 0x00020002u)
            m_mediaSopClassUid = uidText(bytes, element);
        at = element.value + element.length;
    }
    m_dataSetAt = at;
    if (m_transferSyntaxUid.isEmpty()) {
        const bool explicitVr = bytes.size() - at >= 8 && looksLikeVr(bytes, at + 4);
        m_transferSyntaxUid = explicitVr ? QStringLiteral("1.2.840.10008.1.2.1")
                                         : QStringLiteral("1.2.840.10008.1.2");
    }
    return {};
}

/// Writers that name the wrong one of the two little-endian forms show it in the first element,
/// which is short: its length is no two letters.
void DicomFile::chooseForm()
{
    if (!m_form.bigEndian && m_dataSet.size() >= 8)
        m_form.explicitVr = looksLikeVr(m_dataSet, 4);
}

Result<void> DicomFile::checkPlain()
{
    Result<PreflightFacts> facts = preflight(m_dataSet, m_form, m_path);
    if (!facts)
        return tl::unexpected<Error>(facts.error());
    m_facts = std::move(*facts);
    if (m_facts.pixelsCut && !m_facts.pixelsEncapsulated)
        m_facts.pixels.size = m_dataSet.size() - m_facts.pixels.at;
    return {};
}

Result<void> DicomFile::checkDeflated(Extent extent)
{
    constexpr std::size_t firstReach = 1 << 16;
    constexpr std::size_t longestHeader = 256u << 20;
    // Headers are words; it is masks that are nothing but zeros for long.
    constexpr std::size_t freeHeader = 4u << 20;
    for (std::size_t reach = firstReach;; reach *= 2) {
        const Inflater::State state = m_inflater->growTo(reach, freeHeader);
        if (state == Inflater::State::TooLarge || reach > longestHeader) {
            return failure(ErrorCode::FileUnreadable, m_path,
                Clause::saying("the deflated data grow beyond any sensible size"));
        }
        const bool all = state != Inflater::State::More;
        Result<PreflightFacts> facts = preflight(m_inflater->bytes(), m_form, m_path);
        // What is missing may still come: the header is walked again when twice as much is there.
        const bool enough =
            facts ? facts->hasPixels || all : all || facts.error().code != ErrorCode::FileTruncated;
        if (!enough)
            continue;
        if (!facts && state == Inflater::State::Damaged) {
            return failure(
                ErrorCode::FileTruncated, m_path, Clause::saying("damaged deflated data"));
        }
        if (!facts)
            return tl::unexpected<Error>(facts.error());
        m_facts = std::move(*facts);
        break;
    }
    if (extent == Extent::Pixels && m_facts.hasPixels)
        inflatePixels();
    m_dataSet = m_inflater->bytes();
    const std::size_t left = m_dataSet.size() - std::min(m_dataSet.size(), m_facts.pixels.at);
    // No pixel data that are cut: they have not been asked for.
    m_facts.pixelsCut = m_facts.pixelsCut && m_inflater->state() != Inflater::State::More;
    if (m_facts.pixelsCut)
        m_facts.pixels.size = std::min(m_facts.pixels.size, left);
    return {};
}

/// As much as the image needs, which may be less than there claims to be.
void DicomFile::inflatePixels()
{
    const std::size_t wanted =
        std::min<std::size_t>(m_facts.pixels.size, m_facts.image.bytes().value_or(0));
    m_inflater->growTo(m_facts.pixels.at + wanted);
    m_facts.pixelsCut = m_inflater->bytes().size() < m_facts.pixels.at + wanted;
}

/// Memory is asked for by what a header promises: a few bytes must not promise gigabytes.
Result<void> DicomFile::checkCompression() const
{
    constexpr std::uint64_t freeBytes = 64u << 20;
    constexpr std::uint64_t maximumRatio = 1000;
    const std::uint64_t promised = m_facts.image.bytes().value_or(0);
    if (!m_facts.pixelsEncapsulated || m_facts.pixelsCut || promised <= freeBytes)
        return {};
    std::uint64_t held = 0;
    for (const ByteRange& fragment : m_facts.fragments)
        held += fragment.size;
    if (promised / maximumRatio <= held)
        return {};
    return failure(ErrorCode::FileUnreadable, m_path,
        Clause::saying("%1 bytes of pixel data cannot hold an image of %2 × %3 pixels in %4 frames",
            held, m_facts.image.columns, m_facts.image.rows, m_facts.image.frames));
}

Result<void> DicomFile::checkRle() const
{
    // A frame is one fragment (PS3.5 A.4.2); one that is torn apart is still the only one.
    const std::uint64_t frames = m_facts.image.frames;
    const bool framesAreFragments = frames == m_facts.fragments.size();
    if (m_facts.pixelsCut || (frames != 1 && !framesAreFragments))
        return {};
    std::vector<Bytes> rest = fragments();
    while (!rest.empty()) {
        std::array<std::uint8_t, rleHeaderSize> header{};
        std::size_t filled = 0;
        std::size_t size = 0;
        const std::size_t count = frames == 1 ? rest.size() : 1;
        for (const Bytes fragment : std::span(rest).last(count)) {
            const std::size_t taken = std::min(fragment.size(), header.size() - filled);
            std::copy_n(fragment.begin(), taken, header.begin() + std::ptrdiff_t(filled));
            filled += taken;
            size += fragment.size();
        }
        rest.resize(rest.size() - count);
        if (!isRleHeader(std::span(header).first(filled), size, m_facts.image.frameBytes()))
            return failure(ErrorCode::FileUnreadable, m_path, Clause::saying("damaged RLE data"));
    }
    return {};
}

Result<void> DicomFile::readInto(DcmDataset& set) const
{
    readyDcmtk();
    E_TransferSyntax syntax = EXS_LittleEndianImplicit;
    if (m_inflater)
        syntax = EXS_DeflatedLittleEndianExplicit;
    else if (m_form.bigEndian)
        syntax = EXS_BigEndianExplicit;
    else if (m_form.explicitVr)
        syntax = EXS_LittleEndianExplicit;
    // The syntax is the one that was checked, whatever DCMTK would make of the file by itself.
    constexpr Uint32 longestValue = 1024;
    // What stands behind the pixel data was not checked.
    DcmTagKey end = DCM_PixelData;
    if (m_facts.floatBits != 0)
        end = m_facts.floatBits == 32 ? DCM_FloatPixelData : DCM_DoubleFloatPixelData;
    DcmInputFileStream stream(QFile::encodeName(m_path).constData());
    OFCondition read = stream.status();
    if (read.good() && !m_dataSet.empty()) {
        // Skipped, not begun behind: long values are fetched from where the stream was, by its own
        // count.
        stream.skip(offile_off_t(m_dataSetAt));
        set.transferInit();
        read = set.readUntilTag(stream, syntax, EGL_noChange, longestValue, end);
        set.transferEnd();
    }
    if (read.bad())
        return failure(ErrorCode::FileUnreadable, m_path, QString::fromLatin1(read.text()));
    return {};
}

Result<void> DicomFile::readHeader(const QString& path, DcmDataset& set)
{
    if (!QFileInfo::exists(path))
        return failure(ErrorCode::FileNotFound, path);
    const Result<DicomFile> file = open(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    return file->readInto(set);
}

DicomFile::Bytes DicomFile::pixels() const
{
    if (!m_facts.hasPixels || m_facts.pixelsEncapsulated)
        return {};
    const Bytes rest = m_dataSet.subspan(std::min(m_dataSet.size(), m_facts.pixels.at));
    return rest.first(std::min(rest.size(), m_facts.pixels.size));
}

std::vector<DicomFile::Bytes> DicomFile::fragments() const
{
    std::vector<Bytes> all;
    all.reserve(m_facts.fragments.size());
    for (const ByteRange& range : m_facts.fragments)
        all.push_back(m_dataSet.subspan(range.at, range.size));
    return all;
}

} // namespace core
