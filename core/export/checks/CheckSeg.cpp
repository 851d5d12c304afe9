// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckExport.h"

#include "core/dicom/objects/SegReader.h"
#include "core/export/common/CheckSources.h"
#include "core/export/common/Occupancy.h"

#include <QHash>

#include <algorithm>
#include <cmath>
#include <set>

namespace core {

namespace {

/// Copied text can only differ where it had to be shortened to 16 characters.
constexpr double copiedPositionToleranceMm = 1e-4;
constexpr double copiedDirectionTolerance = 1e-6;
constexpr double copiedSpacingTolerance = 1e-6; ///< relative
QString differenceOfPlanes(const HeaderPlane& a, const HeaderPlane& b)
{
    if (glm::distance(a.position, b.position) > copiedPositionToleranceMm)
        return QStringLiteral("position %1 instead of %2").arg(inMm(a.position), inMm(b.position));
    if (glm::distance(a.rowDirection, b.rowDirection) > copiedDirectionTolerance
        || glm::distance(a.columnDirection, b.columnDirection) > copiedDirectionTolerance)
        return QStringLiteral("orientation %1, %2 instead of %3, %4")
            .arg(inMm(a.rowDirection), inMm(a.columnDirection), inMm(b.rowDirection),
                inMm(b.columnDirection))
            .remove(QStringLiteral(" mm"));
    if (std::abs(a.rowSpacing - b.rowSpacing) > copiedSpacingTolerance * b.rowSpacing
        || std::abs(a.columnSpacing - b.columnSpacing) > copiedSpacingTolerance * b.columnSpacing)
        return QStringLiteral("spacing %1 by %2 mm instead of %3 by %4 mm")
            .arg(a.rowSpacing)
            .arg(a.columnSpacing)
            .arg(b.rowSpacing)
            .arg(b.columnSpacing);
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
        const bool inside = m_plane->labels[voxel] == m_label;
        if (!m_fractional)
            return inside ? 1 : 0;
        return occupancyOf(inside, m_coverage.empty() ? (inside ? 255 : 0) : m_coverage[voxel]);
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
    std::uint8_t m_label = 0;
    bool m_fractional = false;
};

/// Compares one frame's pixels with a slice of the labels.
QString differenceOfPixels(
    const SegFile& seg, std::size_t frame, const Expected& expected, std::size_t sliceOffset)
{
    std::size_t wrong = 0;
    std::size_t i = sliceOffset;
    for (int row = 0; row < seg.rows; ++row) {
        for (int column = 0; column < seg.columns; ++column, ++i)
            wrong += seg.value(frame, column, row) != expected.at(i) ? 1U : 0U;
    }
    return wrong == 0 ? QString() : QStringLiteral("%1 voxels are not as drawn").arg(wrong);
}

/// Compares one frame of a label map with the labels of all segments.
QString differenceOfMap(const SegFile& seg, std::size_t frame, const ExportExpectation& expected,
    std::size_t sliceOffset)
{
    std::vector<Expected> segments;
    for (const Segment& segment : expected.segments) {
        segments.emplace_back(expected, segment);
        if (!segments.back().fits(expected.volume.geometry.voxelCount()))
            return QStringLiteral("labels to compare with are missing");
    }
    std::size_t wrong = 0;
    std::size_t i = sliceOffset;
    for (int row = 0; row < seg.rows; ++row) {
        for (int column = 0; column < seg.columns; ++column, ++i) {
            const int number = seg.value(frame, column, row);
            bool right = number <= int(segments.size());
            for (std::size_t s = 0; s < segments.size(); ++s)
                right = right && (segments[s].at(i) != 0) == (number == int(s) + 1);
            wrong += right ? 0U : 1U;
        }
    }
    return wrong == 0 ? QString() : QStringLiteral("%1 voxels are not as drawn").arg(wrong);
}

} // namespace

Result<ReportLines> checkSegExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress)
{
    const Volume& volume = expected.volume;
    const glm::ivec3 size = volume.geometry.size;
    const auto mismatch = [&](const QString& what) {
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
        return mismatch(QStringLiteral("the type of the segmentation"));
    if (isMap && !seg.segments.empty() && seg.segments.front().number == 0)
        seg.segments.erase(seg.segments.begin()); // the background is none
    if (seg.columns != size.x || seg.rows != size.y)
        return mismatch(QStringLiteral("rows or columns"));
    if (seg.segments.size() != expected.segments.size())
        return mismatch(QStringLiteral("the number of segments"));
    for (std::size_t i = 0; i < seg.segments.size(); ++i) {
        if (seg.segments[i].number != int(i) + 1
            || !(seg.segments[i].type == expected.segments[i].code))
            return mismatch(QStringLiteral("number or code of segment %1").arg(i + 1));
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
            return mismatch(QStringLiteral("two slices come from one image"));
        sliceOfInstance.insert(key, k);
        if (!seg.referencedSopUids.contains(header.sopInstanceUid))
            return mismatch(QStringLiteral("source %1 is not referenced").arg(name));
    }

    const std::size_t sliceVoxels = std::size_t(size.x) * std::size_t(size.y);
    std::set<std::pair<int, int>> seen;
    for (std::size_t i = 0; i < seg.frames.size(); ++i) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::CheckingFrames, int(i), int(seg.frames.size()));
        const SegFrame& frame = seg.frames[i];
        const auto atFrame = [&](const QString& what) {
            return mismatch(QStringLiteral("frame %1: %2").arg(i + 1).arg(what));
        };
        const QString key =
            QStringLiteral("%1/%2").arg(frame.referencedSopUid).arg(frame.referencedFrame);
        if (!sliceOfInstance.contains(key))
            return atFrame(QStringLiteral("its source image is none of the volume's"));
        const int k = sliceOfInstance.value(key);
        const SourceHeader& header = (*headers)[std::size_t(k)];
        if (const QString what = differenceOfPlanes(frame.plane, header.plane); !what.isEmpty())
            return atFrame(what);
        if (seg.frameOfReferenceUid
            != (volume.identity.frameOfReferenceUid.isEmpty() ? QString()
                                                              : header.frameOfReferenceUid))
            return atFrame(QStringLiteral("frame of reference"));
        if (const QString what = differenceOfPatients(seg.patient, header.patient); !what.isEmpty())
            return atFrame(what);
        if (seg.studyUid != header.studyUid)
            return atFrame(QStringLiteral("study"));
        const std::size_t offset = std::size_t(k) * sliceVoxels;
        QString what = isMap ? differenceOfMap(seg, i, expected, offset) : QString();
        if (!isMap) {
            if (frame.segment < 1 || frame.segment > int(expected.segments.size()))
                return atFrame(QStringLiteral("segment number"));
            const Expected pixels(expected, expected.segments[std::size_t(frame.segment - 1)]);
            if (!pixels.fits(volume.geometry.voxelCount()))
                return mismatch(QStringLiteral("labels to compare with are missing"));
            what = differenceOfPixels(seg, i, pixels, offset);
        }
        if (!what.isEmpty())
            return atFrame(what);
        if (!seen.emplace(isMap ? 0 : frame.segment, k).second)
            return atFrame(QStringLiteral("the slice occurs twice"));
    }
    for (std::size_t s = 0; s < expected.segments.size(); ++s) {
        const Expected pixels(expected, expected.segments[s]);
        for (int k = 0; k < size.z; ++k) {
            if (seen.count({isMap ? 0 : int(s) + 1, k}) == 0
                && pixels.fits(volume.geometry.voxelCount())
                && pixels.anyIn(std::size_t(k) * sliceVoxels, sliceVoxels))
                return mismatch(QStringLiteral("slice %1 of segment '%2' is missing")
                                    .arg(k + 1)
                                    .arg(expected.segments[s].name));
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
