// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/LabelMapSegWriter.h"
#include "core/dicom/write/SegWriter.h"
#include "core/export/common/CheckSources.h"
#include "core/export/common/MaskSelection.h"
#include "core/export/common/Occupancy.h"
#include "core/repair/RepairVolume.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

Occupancy occupancyOf(const ExportRequest& request, const Segment& segment, const glm::ivec3& size)
{
    const SegmentCoverage* made = coverageOf(request.coverages, segment);
    return {planeOf(request, segment)->labels, segment.label,
        made ? made->coverage : std::span<const std::uint8_t>(), size};
}

/// True where two segments share a voxel.
bool overlap(const ExportRequest& request, const std::vector<Segment>& segments, bool fractional,
    const glm::ivec3& size)
{
    for (std::size_t a = 0; a < segments.size(); ++a) {
        for (std::size_t b = a + 1; b < segments.size(); ++b) {
            const Occupancy first = occupancyOf(request, segments[a], size);
            const Occupancy second = occupancyOf(request, segments[b], size);
            // Of one plane, only what is filled in part can be filled twice.
            const bool partial = fractional && (first.hasCoverage() || second.hasCoverage());
            if (segments[a].plane == segments[b].plane && !partial)
                continue;
            const std::size_t count = planeOf(request, segments[a])->labels.size();
            const std::uint8_t least = fractional ? 1 : 128;
            for (std::size_t i = 0; i < count; ++i) {
                if (first.at(i) >= least && second.at(i) >= least)
                    return true;
            }
        }
    }
    return false;
}

/// Frames of bits, of the slices that hold a voxel.
void addBinary(SegContent& content, const ExportRequest& request, const MaskSelection& selection,
    std::size_t count)
{
    FrameBits bits;
    for (std::size_t s = 0; s < selection.segments.size(); ++s) {
        const auto labels = planeOf(request, selection.segments[s])->labels;
        for (const int k : selection.slices[s]) {
            content.frames.push_back({.segment = int(s), .slice = k});
            bits.append(labels.subspan(std::size_t(k) * count, count), selection.segments[s].label);
        }
    }
    content.pixels = bits.take();
}

/// Frames of bytes, of the slices in which anything is filled.
void addFractional(SegContent& content, const ExportRequest& request,
    const MaskSelection& selection, const glm::ivec3& size)
{
    const std::size_t count = std::size_t(size.x) * std::size_t(size.y);
    std::vector<std::uint8_t> frame(count);
    for (std::size_t s = 0; s < selection.segments.size(); ++s) {
        const Occupancy shares = occupancyOf(request, selection.segments[s], size);
        for (std::size_t k = 0; k < content.sources.size(); ++k) {
            bool any = false;
            for (std::size_t i = 0; i < count; ++i) {
                frame[i] = shares.at(k * count + i);
                any = any || frame[i] != 0;
            }
            if (!any)
                continue;
            content.frames.push_back({.segment = int(s), .slice = int(k)});
            content.pixels.insert(content.pixels.end(), frame.begin(), frame.end());
        }
    }
    if (content.pixels.size() % 2 != 0)
        content.pixels.push_back(0);
}

/// One frame a slice: each pixel the number of its segment, from 1.
Result<void> addLabelMap(SegContent& content, const ExportRequest& request,
    const MaskSelection& selection, std::size_t count)
{
    if (const Clause why = whyNoLabelMap(request, selection.segments, QStringLiteral("DICOM SEG"));
        !why.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, request.file, why);
    std::vector<std::uint8_t> frame(count);
    for (std::size_t k = 0; k < content.sources.size(); ++k) {
        std::fill(frame.begin(), frame.end(), std::uint8_t(0));
        bool any = false;
        for (std::size_t s = 0; s < selection.segments.size(); ++s) {
            const Segment& segment = selection.segments[s];
            const auto labels = planeOf(request, segment)->labels.subspan(k * count, count);
            for (std::size_t i = 0; i < count; ++i) {
                if (labels[i] != segment.label)
                    continue;
                frame[i] = std::uint8_t(s + 1);
                any = true;
            }
        }
        if (!any)
            continue;
        content.frames.push_back({.segment = 0, .slice = int(k)});
        content.pixels.insert(content.pixels.end(), frame.begin(), frame.end());
    }
    if (content.pixels.size() % 2 != 0)
        content.pixels.push_back(0);
    return {};
}

ReportSentence typeOf(const SegContent& content)
{
    ReportSentence type{ReportCode::BinarySeg};
    if (content.type == SegContent::Type::Fractional)
        type = {ReportCode::FractionalSeg};
    else if (content.type == SegContent::Type::LabelMap)
        type = {ReportCode::LabelMapSeg};
    return content.settings.deflated
        ? ReportSentence{ReportCode::DeflatedSeg, {inReport(std::move(type))}}
        : type;
}

/// What a fractional SEG says of each segment, as a sentence.
ReportSentence sharesOf(const ExportRequest& request, const std::vector<Segment>& segments)
{
    std::vector<ReportSentence> made;
    std::vector<ReportSentence> whole;
    for (const Segment& segment : segments) {
        if (const SegmentCoverage* from = coverageOf(request.coverages, segment))
            made.push_back({ReportCode::AsLayerCovers, {segment.name, from->layer}});
        else
            whole.push_back({ReportCode::Quoted, {segment.name}});
    }
    ReportSentence::Listed both{.joiner = ReportCode::Space};
    if (!made.empty())
        both.all.push_back({ReportCode::FilledInPart, {inReport(std::move(made))}});
    if (!whole.empty())
        both.all.push_back({ReportCode::WithoutCoverage, {inReport(std::move(whole))}});
    return {ReportCode::Joined, {std::move(both)}};
}

} // namespace

Result<ReportLines> writeSegMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress,
    ExportReport& report)
{
    const VolumeGeometry& geometry = volume.geometry;
    SegContent content;
    content.identity = volume.identity;
    content.repair = repairMade(volume);
    content.sources = volume.sources;
    content.keptHeaders = volume.keptHeaders;
    content.columns = geometry.size.x;
    content.rows = geometry.size.y;
    if (geometry.slicePositions.empty() && geometry.size.z > 1) {
        const glm::dmat3 axes(geometry.indexToWorld);
        content.sliceDistanceMm =
            std::abs(glm::dot(axes[2], glm::normalize(glm::cross(axes[0], axes[1]))));
    }
    content.segments = selection.segments;
    content.category = request.category;
    content.settings = request.seg;
    content.deidentifier = request.deidentifier;
    Result<SegWritten> written;
    if (request.format == ExportFormat::DicomSegLabelMap) {
        content.type = SegContent::Type::LabelMap;
        if (const auto added = addLabelMap(content, request, selection, voxelsPerSlice(volume));
            !added)
            return tl::unexpected(added.error());
        written = writeLabelMapSeg(path, content, progress);
        report.cautions += ReportSentence{ReportCode::LabelMapsAreNew};
    } else {
        const bool fractional = request.format == ExportFormat::DicomSegFractional;
        content.type = fractional ? SegContent::Type::Fractional : SegContent::Type::Binary;
        content.segmentsOverlap = overlap(request, selection.segments, fractional, geometry.size);
        if (fractional)
            addFractional(content, request, selection, geometry.size);
        else
            addBinary(content, request, selection, voxelsPerSlice(volume));
        written = writeSeg(path, content, progress);
    }
    if (!written)
        return tl::unexpected(written.error());
    report.cautions += written->notes;
    if (volume.identity.frameOfReferenceUid.isEmpty())
        report.cautions += ReportSentence{ReportCode::NoFrameOfReference};
    ReportLines sentences{ReportSentence{ReportCode::DicomSeg,
        {inReport(typeOf(content)),
            countedInReport(ReportCode::Segments, std::int64_t(content.segments.size())),
            countedInReport(ReportCode::Frames, std::int64_t(content.frames.size())),
            content.columns, content.rows}}};
    if (content.type == SegContent::Type::Fractional)
        sentences += sharesOf(request, selection.segments);
    return sentences;
}

} // namespace core
