// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckExport.h"

#include "core/dicom/objects/RtStructFile.h"
#include "core/export/common/CheckSources.h"

#include <QHash>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace core {

namespace {

/// Written numbers are rounded to a thousandth of a pixel, and never more coarsely than this.
constexpr double planeToleranceMm = 1e-3;

/// How often each pixel's centre lies within contours, each of which is filled even-odd by itself.
class FilledSlice {
public:
    explicit FilledSlice(const glm::ivec2& size)
        : m_size(size)
        , m_counts(std::size_t(size.x) * std::size_t(size.y), 0)
    {
    }

    void fill(const std::vector<glm::dvec2>& points)
    {
        double top = points.front().y;
        double bottom = top;
        for (const glm::dvec2& point : points) {
            top = std::min(top, point.y);
            bottom = std::max(bottom, point.y);
        }
        const int first = std::max(0, int(std::ceil(std::max(top, -1.0))));
        const int last =
            std::min(m_size.y - 1, int(std::floor(std::min(bottom, double(m_size.y)))));
        std::vector<std::vector<double>> crossings(std::size_t(std::max(0, last - first + 1)));
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec2& a = points[i];
            const glm::dvec2& b = points[(i + 1) % points.size()];
            const double low = std::min(a.y, b.y);
            const double high = std::max(a.y, b.y);
            const int from = std::max(first, int(std::ceil(std::max(low, -1.0))));
            for (int row = from; row <= last && double(row) < high; ++row)
                crossings[std::size_t(row - first)].push_back(
                    a.x + (b.x - a.x) * (double(row) - a.y) / (b.y - a.y));
        }
        for (int row = first; row <= last; ++row)
            fillRow(row, crossings[std::size_t(row - first)]);
    }

    [[nodiscard]] int count(std::size_t pixel) const { return m_counts[pixel]; }

private:
    void fillRow(int row, std::vector<double>& crossings)
    {
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const int from = std::max(0, int(std::ceil(std::max(crossings[i], -1.0))));
            for (int column = from; column < m_size.x && double(column) < crossings[i + 1];
                 ++column) {
                std::uint8_t& count =
                    m_counts[std::size_t(row) * std::size_t(m_size.x) + std::size_t(column)];
                count = std::uint8_t(std::min(count + 1, 255));
            }
        }
    }

    glm::ivec2 m_size;
    std::vector<std::uint8_t> m_counts;
};

/// The points as columns and rows of the image; nothing if one lies off its plane.
std::optional<std::vector<glm::dvec2>> inPlane(
    const std::vector<glm::dvec3>& points, const HeaderPlane& plane)
{
    const glm::dvec3 normal = glm::normalize(glm::cross(plane.rowDirection, plane.columnDirection));
    const glm::dmat3 axes(
        plane.rowDirection * plane.columnSpacing, plane.columnDirection * plane.rowSpacing, normal);
    const glm::dmat3 toPlane = glm::inverse(axes);
    std::vector<glm::dvec2> places;
    places.reserve(points.size());
    for (const glm::dvec3& point : points) {
        const glm::dvec3 place = toPlane * (point - plane.position);
        if (!(std::abs(place.z) <= planeToleranceMm))
            return std::nullopt;
        places.emplace_back(place);
    }
    return places;
}

struct Check {
    const QString& file;
    const ExportExpectation& expected;
    const RtStructFile& set;
    const std::vector<SourceHeader>& headers;
    QHash<QString, int> sliceOfInstance;

    [[nodiscard]] tl::unexpected<Error> mismatch(const Clause& what) const
    {
        return failure(ErrorCode::ExportMismatch, file, what);
    }

    Result<void> sources()
    {
        const Volume& volume = expected.volume;
        for (std::size_t k = 0; k < headers.size(); ++k) {
            const SourceHeader& header = headers[k];
            const QString key =
                QStringLiteral("%1/%2").arg(header.sopInstanceUid).arg(volume.sources[k].frame);
            if (sliceOfInstance.contains(key))
                return mismatch(Clause::saying("two slices come from one image"));
            sliceOfInstance.insert(key, int(k));
            if (const Clause what = differenceFromSource(set.patient, header.patient);
                !what.isEmpty())
                return mismatch(what);
            if (set.studyUid != header.studyUid)
                return mismatch(QStringLiteral("study"));
            if (!volume.identity.frameOfReferenceUid.isEmpty()
                && set.frameOfReferenceUid != header.frameOfReferenceUid)
                return mismatch(Clause::saying("frame of reference"));
        }
        const std::set<QString> named(set.referencedSopUids.begin(), set.referencedSopUids.end());
        for (std::size_t k = 0; k < headers.size(); ++k) {
            if (named.count(headers[k].sopInstanceUid) == 0)
                return mismatch(
                    Clause::saying("source %1 is not referenced", volume.sources[k].file));
        }
        return {};
    }

    Result<void> roi(std::size_t index, const Progress& progress) const
    {
        const RtRoi& roi = set.rois[index];
        const Segment& segment = expected.segments[index];
        const auto inRoi = [&](const Clause& what) {
            return mismatch(Clause::saying("segment '%1': %2", segment.name, what));
        };
        if (roi.number != int(index) + 1)
            return inRoi(Clause::saying("its number"));
        if (roi.name.simplified() != nameOf(segment))
            return inRoi(Clause::saying("its name"));
        if (roi.rgb != (segment.rgb & 0xffffffU))
            return inRoi(Clause::saying("its colour"));
        if (roi.frameOfReferenceUid != set.frameOfReferenceUid)
            return inRoi(Clause::saying("its frame of reference"));
        const LabelPlaneView* plane = nullptr;
        for (const LabelPlaneView& view : expected.planes) {
            if (view.plane == segment.plane)
                plane = &view;
        }
        if (plane == nullptr || plane->labels.size() != expected.volume.geometry.voxelCount())
            return mismatch(Clause::saying("labels to compare with are missing"));

        std::map<int, std::vector<const RtContour*>> ofSlice;
        for (const RtContour& contour : roi.contours) {
            const QString key =
                QStringLiteral("%1/%2").arg(contour.referencedSopUid).arg(contour.referencedFrame);
            if (!sliceOfInstance.contains(key))
                return inRoi(Clause::saying("the image of a contour is none of the volume's"));
            if (contour.saidPoints != int(contour.points.size()))
                return inRoi(Clause::saying("a contour has not as many points as it says"));
            if (contour.geometricType != QLatin1String("CLOSED_PLANAR"))
                return inRoi(Clause::saying("a contour is not closed and planar"));
            ofSlice[sliceOfInstance.value(key)].push_back(&contour);
        }
        for (int k = 0; k < expected.volume.geometry.size.z; ++k) {
            if (progress.cancelled())
                return failure(ErrorCode::Cancelled);
            const auto found = ofSlice.find(k);
            const auto contours =
                found == ofSlice.end() ? std::vector<const RtContour*>() : found->second;
            if (const Clause what = slice(k, contours, *plane, segment.label); !what.isEmpty())
                return inRoi(Clause::saying("slice %1: %2", k + 1, what));
        }
        return {};
    }

private:
    /// As a text of 64 characters without marks can say it.
    static QString nameOf(const Segment& segment)
    {
        QString plain;
        for (const QChar character : segment.name) {
            if (character.category() != QChar::Other_Control && character != u'\\')
                plain += character;
        }
        plain = plain.trimmed().left(64).simplified();
        return plain.isEmpty() ? QStringLiteral("Segment") : plain;
    }

    /// @return what is not as drawn; empty if all is
    [[nodiscard]] Clause slice(int k, const std::vector<const RtContour*>& contours,
        const LabelPlaneView& plane, std::uint8_t label) const
    {
        const glm::ivec2 size(expected.volume.geometry.size);
        FilledSlice filled(size);
        for (const RtContour* contour : contours) {
            const auto points = inPlane(contour->points, headers[std::size_t(k)].plane);
            if (!points)
                return Clause::saying("a contour does not lie in the plane of its image");
            filled.fill(*points);
        }
        const std::size_t count = std::size_t(size.x) * std::size_t(size.y);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const bool drawn = plane.labels[std::size_t(k) * count + i] == label;
            wrong += filled.count(i) != (drawn ? 1 : 0) ? 1U : 0U;
        }
        return wrong == 0 ? Clause() : Clause::saying("%1 voxels are not as drawn", wrong);
    }
};

} // namespace

Result<ReportLines> checkRtStructExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress)
{
    const auto set = readRtStruct(file);
    if (!set)
        return tl::unexpected(set.error());
    const auto headers = checkedSourceHeaders(file, expected, progress);
    if (!headers)
        return tl::unexpected(headers.error());
    Check check{file, expected, *set, *headers, {}};
    if (set->rois.size() != expected.segments.size())
        return check.mismatch(Clause::saying("the number of segments"));
    if (set->contoursOfNone != 0)
        return check.mismatch(Clause::saying("contours of a region that is not named"));
    if (const auto same = check.sources(); !same)
        return tl::unexpected(same.error());
    std::size_t contours = 0;
    for (std::size_t i = 0; i < set->rois.size(); ++i) {
        progress.report(ProgressStep::CheckingContours, int(i), int(set->rois.size()));
        if (const auto same = check.roi(i, progress); !same)
            return tl::unexpected(same.error());
        contours += set->rois[i].contours.size();
    }
    return ReportLines{
        ReportSentence{ReportCode::ContoursInPlanes,
            {countedInReport(ReportCode::Contours, std::int64_t(contours)),
                countedInReport(ReportCode::SourceHeaders, std::int64_t(headers->size()))}},
        ReportSentence{ReportCode::ContoursFilled,
            {countedInReport(ReportCode::Segments, std::int64_t(expected.segments.size()))}}};
}

} // namespace core
