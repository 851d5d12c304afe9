// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckExport.h"

#include "core/dicom/objects/SegReader.h"
#include "core/export/common/CheckSources.h"
#include "core/export/common/Occupancy.h"

#include <QHash>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace core {

namespace {

/// Copied text can only differ where it had to be shortened to 16 characters.
constexpr double copiedPositionToleranceMm = 1e-4;
constexpr double copiedDirectionTolerance = 1e-6;
constexpr double copiedSpacingTolerance = 1e-6; ///< relative
Clause differenceOfPlanes(const HeaderPlane& a, const HeaderPlane& b)
{
    if (glm::distance(a.position, b.position) > copiedPositionToleranceMm)
        return Clause::saying("position %1 instead of %2", inMm(a.position), inMm(b.position));
    const auto direction = [](const glm::dvec3& of) {
        return inMm(of).remove(QStringLiteral(" mm"));
    };
    if (glm::distance(a.rowDirection, b.rowDirection) > copiedDirectionTolerance
        || glm::distance(a.columnDirection, b.columnDirection) > copiedDirectionTolerance)
        return Clause::saying("orientation %1, %2 instead of %3, %4", direction(a.rowDirection),
            direction(a.columnDirection), direction(b.rowDirection), direction(b.columnDirection));
    if (std::abs(a.rowSpacing - b.rowSpacing) > copiedSpacingTolerance * b.rowSpacing
        || std::abs(a.columnSpacing - b.columnSpacing) > copiedSpacingTolerance * b.columnSpacing)
        return Clause::saying("spacing %1 by %2 mm instead of %3 by %4 mm", a.rowSpacing,
            a.columnSpacing, b.rowSpacing, b.columnSpacing);
    return {};
}

const LabelPlaneView* planeOf(const ExportExpectation& expected, const Segment& segment)
{
    for (const LabelPlaneView& plane : expected.planes) {
        if (plane.plane == segment.plane)
            return &plane;
    }
    return nullptr;
}

/// What a pixel must be: 1 or 0, or how much of it is filled.
class Expected {
public:
    Expected(const ExportExpectation& expected, const Segment& segment)
        : m_plane(planeOf(expected, segment))
        , m_size(expected.volume.geometry.size)
        , m_label(segment.label)
        , m_fractional(expected.format == ExportFormat::DicomSegFractional)
    {
        for (const SegmentCoverage& each : expected.coverages) {
            if (each.label == segment.label)
                m_coverage = each.coverage;
        }
    }
    [[nodiscard]] bool fits(std::size_t voxels) const
    {
        return m_plane != nullptr && m_plane->labels.size() == voxels
            && (m_coverage.empty() || m_coverage.size() == voxels);
    }
    [[nodiscard]] int at(std::size_t voxel) const
    {
        if (!m_fractional)
            return m_plane->labels[voxel] == m_label ? 1 : 0;
        return Occupancy(m_plane->labels, m_label, m_coverage, m_size).at(voxel);
    }
    [[nodiscard]] bool anyIn(std::size_t offset, std::size_t count) const
    {
        for (std::size_t i = offset; i < offset + count; ++i) {
            if (at(i) != 0)
                return true;
        }
        return false;
    }

private:
    const LabelPlaneView* m_plane = nullptr;
    std::span<const std::uint8_t> m_coverage;
    glm::ivec3 m_size;
    std::uint8_t m_label = 0;
    bool m_fractional = false;
};

/// Compares one frame's pixels with a slice of the labels.
Clause differenceOfPixels(
    const SegFile& seg, std::size_t frame, const Expected& expected, std::size_t sliceOffset)
{
    std::size_t wrong = 0;
    std::size_t i = sliceOffset;
    for (int row = 0; row < seg.rows; ++row) {
        for (int column = 0; column < seg.columns; ++column, ++i)
            wrong += seg.value(frame, column, row) != expected.at(i) ? 1U : 0U;
    }
    return wrong == 0 ? Clause() : Clause::saying("%1 voxels are not as drawn", wrong);
}

/// The numbers that a label map gives to the segments of a label plane.
struct PlaneNumbers {
    const LabelPlaneView* plane = nullptr;
    std::array<int, 256> ofLabel{}; ///< 0: no segment that was written
};

/// Compares one frame of a label map with the labels of all segments.
Clause differenceOfMap(const SegFile& seg, std::size_t frame, const ExportExpectation& expected,
    std::size_t sliceOffset)
{
    std::map<std::uint8_t, PlaneNumbers> planes;
    for (std::size_t s = 0; s < expected.segments.size(); ++s) {
        const Segment& segment = expected.segments[s];
        if (!Expected(expected, segment).fits(expected.volume.geometry.voxelCount()))
            return Clause::saying("labels to compare with are missing");
        PlaneNumbers& numbers = planes[segment.plane];
        numbers.plane = planeOf(expected, segment);
        numbers.ofLabel[segment.label] = int(s) + 1;
    }
    std::size_t wrong = 0;
    std::size_t i = sliceOffset;
    for (int row = 0; row < seg.rows; ++row) {
        for (int column = 0; column < seg.columns; ++column, ++i) {
            int wanted = 0;
            bool isAlone = true;
            for (const auto& [plane, numbers] : planes) {
                const int number = numbers.ofLabel[numbers.plane->labels[i]];
                isAlone = isAlone && (number == 0 || wanted == 0);
                wanted = std::max(wanted, number);
            }
            wrong += isAlone && seg.value(frame, column, row) == wanted ? 0U : 1U;
        }
    }
    return wrong == 0 ? Clause() : Clause::saying("%1 voxels are not as drawn", wrong);
}

} // namespace

Result<ReportLines> checkSegExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress)
{
    const Volume& volume = expected.volume;
    const glm::ivec3 size = volume.geometry.size;
    const auto mismatch = [&](const Clause& what) {
        return failure(ErrorCode::ExportMismatch, file, what);
    };
    auto read = readSeg(file);
    if (!read)
        return tl::unexpected(read.error());
    SegFile& seg = *read;
    const bool isMap = expected.format == ExportFormat::DicomSegLabelMap;
    SegFile::Type type = SegFile::Type::Binary;
    if (isMap)
        type = SegFile::Type::LabelMap;
    else if (expected.format == ExportFormat::DicomSegFractional)
        type = SegFile::Type::Fractional;
    if (seg.type != type || (type == SegFile::Type::Fractional && seg.fullPixel != 255))
        return mismatch(Clause::saying("the type of the segmentation"));
    if (isMap && !seg.segments.empty() && seg.segments.front().number == 0)
        seg.segments.erase(seg.segments.begin()); // the background is none
    if (seg.columns != size.x || seg.rows != size.y)
        return mismatch(Clause::saying("rows or columns"));
    if (seg.segments.size() != expected.segments.size())
        return mismatch(Clause::saying("the number of segments"));
    for (std::size_t i = 0; i < seg.segments.size(); ++i) {
        if (seg.segments[i].number != int(i) + 1
            || !(seg.segments[i].type == expected.segments[i].code))
            return mismatch(Clause::saying("number or code of segment %1", i + 1));
    }

    const auto headers = checkedSourceHeaders(file, expected, progress);
    if (!headers)
        return tl::unexpected(headers.error());
    QHash<QString, int> sliceOfInstance;
    for (int k = 0; k < int(headers->size()); ++k) {
        const SourceHeader& header = (*headers)[std::size_t(k)];
        const QString name = volume.sources[std::size_t(k)].file;
        const QString key = QStringLiteral("%1/%2")
                                .arg(header.sopInstanceUid)
                                .arg(volume.sources[std::size_t(k)].frame);
        if (sliceOfInstance.contains(key))
            return mismatch(Clause::saying("two slices come from one image"));
        sliceOfInstance.insert(key, k);
        if (!seg.referencedSopUids.contains(header.sopInstanceUid))
            return mismatch(Clause::saying("source %1 is not referenced", name));
    }

    const std::size_t sliceVoxels = std::size_t(size.x) * std::size_t(size.y);
    std::set<std::pair<int, int>> seen;
    for (std::size_t i = 0; i < seg.frames.size(); ++i) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::CheckingFrames, int(i), int(seg.frames.size()));
        const SegFrame& frame = seg.frames[i];
        const auto atFrame = [&](const Clause& what) {
            return mismatch(Clause::saying("frame %1: %2", i + 1, what));
        };
        const QString key =
            QStringLiteral("%1/%2").arg(frame.referencedSopUid).arg(frame.referencedFrame);
        if (!sliceOfInstance.contains(key))
            return atFrame(Clause::saying("its source image is none of the volume's"));
        const int k = sliceOfInstance.value(key);
        const SourceHeader& header = (*headers)[std::size_t(k)];
        if (const Clause what = differenceOfPlanes(frame.plane, header.plane); !what.isEmpty())
            return atFrame(what);
        if (seg.frameOfReferenceUid
            != (volume.identity.frameOfReferenceUid.isEmpty() ? QString()
                                                              : header.frameOfReferenceUid))
            return atFrame(Clause::saying("frame of reference"));
        if (const Clause what = differenceFromSource(seg.patient, header.patient); !what.isEmpty())
            return atFrame(what);
        if (seg.studyUid != header.studyUid)
            return atFrame(QStringLiteral("study"));
        const std::size_t offset = std::size_t(k) * sliceVoxels;
        Clause what = isMap ? differenceOfMap(seg, i, expected, offset) : Clause();
        if (!isMap) {
            if (frame.segment < 1 || frame.segment > int(expected.segments.size()))
                return atFrame(Clause::saying("segment number"));
            const Expected pixels(expected, expected.segments[std::size_t(frame.segment - 1)]);
            if (!pixels.fits(volume.geometry.voxelCount()))
                return mismatch(Clause::saying("labels to compare with are missing"));
            what = differenceOfPixels(seg, i, pixels, offset);
        }
        if (!what.isEmpty())
            return atFrame(what);
        if (!seen.emplace(isMap ? 0 : frame.segment, k).second)
            return atFrame(Clause::saying("the slice occurs twice"));
    }
    for (std::size_t s = 0; s < expected.segments.size(); ++s) {
        const Expected pixels(expected, expected.segments[s]);
        for (int k = 0; k < size.z; ++k) {
            if (seen.count({isMap ? 0 : int(s) + 1, k}) == 0
                && pixels.fits(volume.geometry.voxelCount())
                && pixels.anyIn(std::size_t(k) * sliceVoxels, sliceVoxels))
                return mismatch(Clause::saying(
                    "slice %1 of segment '%2' is missing", k + 1, expected.segments[s].name));
        }
    }
    return ReportLines{
        ReportSentence{ReportCode::FramesAgree,
            {countedInReport(ReportCode::Frames, std::int64_t(seg.frames.size())),
                countedInReport(ReportCode::SourceHeaders, std::int64_t(headers->size()))}},
        ReportSentence{ReportCode::VoxelsOfAsDrawn,
            {countedInReport(ReportCode::Segments, std::int64_t(expected.segments.size()))}}};
}

} // namespace core
