// SPDX-License-Identifier: Apache-2.0
#include "core/masks/ReadImport.h"

#include "core/document/SegmentColours.h"
#include "core/edits/fields/EditFields.h"
#include "core/edits/kinds/imports/ImportMask.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace core {

namespace {

/// As a name of a segment may be.
QString nameFrom(QString text)
{
    constexpr qsizetype longest = 256;
    for (QChar& character : text) {
        if (character.category() == QChar::Other_Control)
            character = QLatin1Char(' ');
    }
    text = text.simplified().left(longest);
    return editFields::Text().check(text).isEmpty() ? text : QStringLiteral("Segment");
}

} // namespace

int ReadImport::planesNeeded() const
{
    return planes.empty() ? 1 : *std::max_element(planes.begin(), planes.end()) + 1;
}

Result<ReadImport> readImport(const ImportMask& edit, const Volume& volume,
    std::size_t segmentsBefore, const Progress& progress)
{
    Result<MaskOnVolume> mask = readMask(edit.file, volume, progress);
    if (!mask)
        return tl::unexpected(mask.error());
    ReadImport read{.edit = edit, .notes = std::move(mask->notes)};
    if (!edit.as && !mask->overlaps.empty()) {
        read.planes = planesFor(mask->overlaps, mask->segments.size());
        read.overlaps = std::move(mask->overlaps);
        if (!edit.ahead && !edit.planes && read.planesNeeded() <= mostLabelPlanes)
            read.edit.planes = read.planes;
    }
    read.edit.file = QFileInfo(QDir::cleanPath(edit.file)).fileName(); // or of the folder
    read.edit.size = volume.geometry.size;
    std::vector<ImportedSegment>& segments = read.edit.segments.emplace();
    for (const MaskSegment& segment : mask->segments) {
        const bool isCode = editFields::Code().check(segment.code).isEmpty();
        segments.push_back({.name = nameFrom(segment.name),
            .rgb = segment.rgb.value_or(usualSegmentColour(segmentsBefore + segments.size())),
            .code = isCode ? segment.code : CodedConcept{},
            .voxels = packedRuns(segment.voxels)});
        if (segments.back().voxels.isEmpty())
            return failure(ErrorCode::UnsupportedFormat, edit.file,
                Clause::saying("the outline of its segment '%1' is too ragged to be kept",
                    segments.back().name));
    }
    return read;
}

Result<void> checkOverlaps(const ReadImport& read)
{
    if (read.edit.ahead || read.edit.planes || read.planesNeeded() <= mostLabelPlanes)
        return {};
    return failure(ErrorCode::UnsupportedFormat, read.edit.file,
        Clause::saying("its segments overlap so that they would need %1 label planes, and there "
                       "are at most %2; with 'ahead' each voxel goes to one of them",
            read.planesNeeded(), mostLabelPlanes));
}

} // namespace core
