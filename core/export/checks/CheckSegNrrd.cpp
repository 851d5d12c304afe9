// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckExport.h"

#include "core/export/common/CheckSources.h"
#include "core/export/common/LabelMap.h"
#include "core/nrrd/NrrdHeader.h"
#include "core/nrrd/NrrdReader.h"

#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace core {

namespace {

/// Its numbers have all their digits: the grid is the volume's but for rounding.
constexpr double writtenToleranceMm = 1e-6;

using Keys = std::map<QByteArray, QByteArray>;

QString valueOf(const Keys& keys, const QByteArray& key)
{
    const auto found = keys.find(key);
    return found == keys.end() ? QString() : QString::fromUtf8(found->second);
}

/// "0.5 1 0" → 0x80ff00
std::optional<std::uint32_t> colourOf(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::uint32_t rgb = 0;
    for (const QString& part : parts) {
        bool isNumber = false;
        const double share = part.toDouble(&isNumber);
        if (!isNumber || !(share >= 0.0 && share <= 1.0))
            return std::nullopt;
        rgb = (rgb << 8U) | std::uint32_t(std::lround(share * 255.0));
    }
    return parts.size() == 3 ? std::optional(rgb) : std::nullopt;
}

/// Letters as they are: a header knows no control characters, and a tag not those that part it.
QString comparable(const QString& text, bool inTag)
{
    QString plain;
    for (const QChar character : text) {
        const bool control = character.category() == QChar::Other_Control && character != u'\n';
        const bool parting = inTag && (character == u'^' || character == u'~' || character == u'|');
        plain += control || parting ? QChar(u' ') : character;
    }
    return plain;
}

/// What the tags of a segment name.
struct NamedCodes {
    CodedConcept type;
    SegCodes others;
};

/// Nothing if the tags are not as they should be; empty codes if there is no terminology.
std::optional<NamedCodes> codesOf(const QString& tags)
{
    const QString name = QStringLiteral("TerminologyEntry:");
    for (const QString& tag : tags.split(QLatin1Char('|'))) {
        if (!tag.startsWith(name))
            continue;
        const QStringList parts = tag.mid(name.size()).split(QLatin1Char('~'));
        if (parts.size() != 7)
            return std::nullopt;
        NamedCodes codes;
        for (const auto& [part, code] : {std::pair(1, &codes.others.category),
                 std::pair(2, &codes.type), std::pair(3, &codes.others.modifier),
                 std::pair(5, &codes.others.region), std::pair(6, &codes.others.regionModifier)}) {
            const QStringList entry = parts[part].split(QLatin1Char('^'));
            if (entry.size() != 3)
                return std::nullopt;
            *code = {.scheme = entry[0], .value = entry[1], .meaning = entry[2]};
        }
        return codes;
    }
    return NamedCodes{};
}

/// As it can stand in a tag.
CodedConcept comparable(const CodedConcept& code)
{
    return {.scheme = comparable(code.scheme, true),
        .value = comparable(code.value, true),
        .meaning = comparable(code.meaning, true)};
}

/// Whether the tags of a segment name its codes and no others.
bool namesCodes(const QString& tags, const Segment& segment, const SegCodes& expected)
{
    const std::optional<NamedCodes> named = codesOf(tags);
    if (!named)
        return false;
    const SegCodes& others = named->others;
    if (!segment.code.isSet())
        return !named->type.isSet() && !others.category.isSet();
    const CodedConcept regionModifier =
        expected.region.isSet() ? comparable(expected.regionModifier) : CodedConcept();
    return named->type == comparable(segment.code)
        && (!expected.category.isSet() || others.category == comparable(expected.category))
        && others.modifier == comparable(expected.modifier)
        && others.region == comparable(expected.region) && others.regionModifier == regionModifier;
}

/// The layer that the header names for a segment; −1 if there is no such layer.
int layerNamed(const Keys& keys, const QByteArray& prefix, int layers)
{
    bool isNumber = false;
    const int layer = valueOf(keys, prefix + "Layer").toInt(&isNumber);
    return isNumber && layer >= 0 && layer < layers ? layer : -1;
}

/// What a segment's keys say that is not so, as a word; empty if all is.
Clause differenceOfSegment(const Keys& keys, const QByteArray& prefix, const Segment& segment,
    const SegCodes& codes, const QString& extent, int layers)
{
    if (valueOf(keys, prefix + "Name") != comparable(segment.name, false))
        return QStringLiteral("name");
    if (valueOf(keys, prefix + "LabelValue") != QString::number(segment.label))
        return Clause::saying("label value");
    if (layerNamed(keys, prefix, layers) < 0)
        return QStringLiteral("layer");
    if (valueOf(keys, prefix + "Extent") != extent)
        return QStringLiteral("extent");
    if (colourOf(valueOf(keys, prefix + "Color")) != (segment.rgb & 0xffffffU))
        return QStringLiteral("colour");
    if (!namesCodes(valueOf(keys, prefix + "Tags"), segment, codes))
        return QStringLiteral("code");
    return {};
}

/// What the keys of the header say that is not so, as a clause; empty if all is.
Clause differenceOfKeys(const Keys& keys, const ExportExpectation& expected, int layers)
{
    const glm::ivec3 size = expected.volume.geometry.size;
    const QString extent =
        QStringLiteral("0 %1 0 %2 0 %3").arg(size.x - 1).arg(size.y - 1).arg(size.z - 1);
    std::set<QString> ids;
    for (std::size_t i = 0; i < expected.segments.size(); ++i) {
        const QByteArray prefix = "Segment" + QByteArray::number(qulonglong(i)) + '_';
        const QString id = valueOf(keys, prefix + "ID");
        if (id.isEmpty() || !ids.insert(id).second)
            return Clause::saying("the ID of segment %1", i + 1);
        const Segment& segment = expected.segments[i];
        const auto codes = expected.segmentCodes.find(segment.label);
        const Clause what = differenceOfSegment(keys, prefix, segment,
            codes == expected.segmentCodes.end() ? SegCodes() : codes->second, extent, layers);
        if (!what.isEmpty())
            return Clause::saying("the %1 of segment %2", what, i + 1);
    }
    const QByteArray next =
        "Segment" + QByteArray::number(qulonglong(expected.segments.size())) + "_ID";
    if (keys.contains(next))
        return Clause::saying("the number of segments");
    for (const char* key : {"MasterRepresentation", "SourceRepresentation"}) {
        if (valueOf(keys, QByteArray("Segmentation_") + key) != QLatin1String("Binary labelmap"))
            return Clause::saying("the representation");
    }
    if (valueOf(keys, "Segmentation_ReferenceImageExtentOffset") != QLatin1String("0 0 0"))
        return Clause::saying("the offset of the extent");
    return {};
}

} // namespace

Result<ReportLines> checkSegNrrdExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress)
{
    const VolumeGeometry& geometry = expected.volume.geometry;
    const auto mismatch = [&](const Clause& what) {
        return failure(ErrorCode::ExportMismatch, file, what);
    };
    const Result<NrrdHeader> header = readNrrdHeader(file);
    if (!header)
        return tl::unexpected(header.error());
    const Result<NrrdLayers> read = readNrrdLayers(file);
    if (!read)
        return tl::unexpected(read.error());
    const GridFile* grid = &read->grid;
    if (grid->geometry.size != geometry.size || grid->voxels.type != ScalarType::UInt8)
        return mismatch(Clause::saying("size or type of the voxels"));
    if (header->field("space") != "left-posterior-superior")
        return mismatch(Clause::saying("the space is not left-posterior-superior"));
    if (const Clause what = differenceOfKeys(header->keyValues, expected, read->layers);
        !what.isEmpty())
        return mismatch(what);

    const auto place = labelMapPlace(file, expected.volume, progress);
    if (!place)
        return tl::unexpected(place.error());
    const GridCorners corners = cornersOf(grid->geometry.indexToWorld, geometry.size);
    const double off = farthest(corners, place->corners);
    if (off > place->toleranceMm)
        return mismatch(Clause::saying("the space directions put a corner %1 mm away from where "
                                       "the source has it",
            off));
    if (farthest(corners, cornersOf(geometry.indexToWorld, geometry.size)) > writtenToleranceMm)
        return mismatch(Clause::saying("the space directions are not those of the volume"));

    const Result<VoxelBytes> bytes = readVoxels(grid->voxels, progress);
    if (!bytes)
        return tl::unexpected(bytes.error());
    if (bytes->surplus)
        return mismatch(Clause::saying("the file holds more than its voxels"));
    const auto* voxels = reinterpret_cast<const std::uint8_t*>(bytes->data.get());
    std::vector<int> layerOf;
    for (std::size_t i = 0; i < expected.segments.size(); ++i)
        layerOf.push_back(layerNamed(
            header->keyValues, "Segment" + QByteArray::number(qulonglong(i)) + '_', read->layers));
    const std::size_t wrong = wrongVoxels({voxels, bytes->size}, expected, layerOf, read->layers);
    if (wrong != 0)
        return mismatch(Clause::saying("%1 voxels are not as drawn", wrong));
    return ReportLines{ReportSentence{ReportCode::CornersOnSource, {QString::number(off, 'f', 4)}},
        ReportSentence{ReportCode::NamesAsGiven,
            {countedInReport(ReportCode::Segments, std::int64_t(expected.segments.size()))}},
        ReportSentence{ReportCode::VoxelsAsDrawn, {std::int64_t(geometry.voxelCount())}}};
}

} // namespace core
