// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/RtStructFile.h"
#include "core/masks/MaskParts.h"
#include "core/masks/PolygonFill.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace core {

namespace {

/// The study's slices, and what contours have to do with them.
class Slices {
public:
    explicit Slices(const VolumeGeometry& geometry)
        : m_geometry(geometry)
    {
        const glm::dvec3 column(geometry.indexToWorld[0]);
        const glm::dvec3 row(geometry.indexToWorld[1]);
        m_normal = glm::normalize(glm::cross(column, row));
        m_toPlane = glm::inverse(glm::dmat3(column, row, m_normal));
        for (int k = 0; k < geometry.size.z; ++k) {
            m_origins.push_back(geometry.slicePositions.empty()
                    ? geometry.toWorld({0.0, 0.0, double(k)})
                    : geometry.slicePositions[std::size_t(k)]);
            m_heights.push_back(glm::dot(m_normal, m_origins.back()));
        }
        for (std::size_t k = 1; k < m_heights.size(); ++k) {
            const double step = std::abs(m_heights[k] - m_heights[k - 1]);
            m_stepMm = k == 1 ? step : std::min(m_stepMm, step);
        }
        if (m_heights.size() < 2)
            m_stepMm = geometry.spacingMm().z;
    }

    [[nodiscard]] double stepMm() const { return m_stepMm; }
    [[nodiscard]] int count() const { return int(m_origins.size()); }
    [[nodiscard]] double heightOf(int k) const { return m_heights[std::size_t(k)]; }
    [[nodiscard]] double heightOf(const glm::dvec3& lps) const { return glm::dot(m_normal, lps); }
    /// Lies in a plane along the slices.
    [[nodiscard]] bool isFlat(const RtContour& contour) const
    {
        const double first = heightOf(contour.points.front());
        return std::all_of(contour.points.begin(), contour.points.end(), [&](const auto& point) {
            return std::abs(heightOf(point) - first) <= std::max(0.01, 0.1 * m_stepMm);
        });
    }
    [[nodiscard]] bool isOnSlice(double height) const
    {
        return std::any_of(m_heights.begin(), m_heights.end(), [&](double slice) {
            return std::abs(slice - height) <= std::max(0.01, 0.01 * m_stepMm);
        });
    }
    /// On a slice, seen along its normal.
    [[nodiscard]] SlicePolygon polygonOn(int k, const RtContour& contour) const
    {
        SlicePolygon polygon;
        for (const glm::dvec3& point : contour.points)
            polygon.points.push_back(
                slicePoint(glm::dvec2(m_toPlane * (point - m_origins[std::size_t(k)]))));
        return polygon;
    }
    [[nodiscard]] const VolumeGeometry& geometry() const { return m_geometry; }

private:
    const VolumeGeometry& m_geometry;
    glm::dvec3 m_normal{0.0};
    glm::dmat3 m_toPlane{1.0};
    std::vector<glm::dvec3> m_origins;
    std::vector<double> m_heights;
    double m_stepMm = 0.0;
};

/// Contours of one height, in mm along the normal; steps of a thousandth are none.
using Planes = std::map<std::int64_t, std::vector<const RtContour*>>;

/// Files may state heights so great that no whole number holds them or their differences.
std::int64_t thousandthsOf(double mm)
{
    constexpr double farthestMm = 1e12;
    return std::llround(std::clamp(mm, -farthestMm, farthestMm) * 1000.0);
}

double mmOf(std::int64_t height)
{
    return double(height) / 1000.0;
}

Planes planesOf(const RtRoi& roi, const Slices& slices)
{
    Planes planes;
    for (const RtContour& contour : roi.contours)
        planes[thousandthsOf(slices.heightOf(contour.points.front()))].push_back(&contour);
    return planes;
}

/// How far a plane of contours reaches: half of it to each side. Where all lie on slices, each is
/// its slice's and no other's.
struct Reach {
    double mm = 0.0;
    bool onSlices = true;
};

Reach reachOf(const RtStructFile& set, const Slices& slices)
{
    Reach reach{.mm = slices.stepMm()};
    std::set<std::int64_t> heights;
    for (const RtRoi& roi : set.rois) {
        for (const auto& [height, contours] : planesOf(roi, slices)) {
            heights.insert(height);
            reach.onSlices = reach.onSlices && slices.isOnSlice(mmOf(height));
        }
    }
    if (reach.onSlices || heights.size() < 2)
        return reach;
    reach.mm = 0.0;
    constexpr double sameMm = 0.01;
    for (auto height = std::next(heights.begin()); height != heights.end(); ++height) {
        const double step = mmOf(*height - *std::prev(height));
        if (step > sameMm && (reach.mm == 0.0 || step < reach.mm))
            reach.mm = step;
    }
    return reach;
}

/// The plane nearest to a slice; null: none reaches it. Midway the upper one does.
const std::vector<const RtContour*>* planeAt(const Planes& planes, double height, double reachMm)
{
    const std::int64_t wanted = thousandthsOf(height);
    const auto above = planes.lower_bound(wanted);
    auto nearest = above;
    if (above != planes.begin()) {
        const auto below = std::prev(above);
        if (above == planes.end() || wanted - below->first < above->first - wanted)
            nearest = below;
    }
    if (nearest == planes.end())
        return nullptr;
    const std::int64_t reach = thousandthsOf(reachMm / 2.0);
    const std::int64_t off = wanted - nearest->first;
    return off >= -reach && off < reach ? &nearest->second : nullptr;
}

VoxelRuns voxelsOf(const Planes& planes, const Slices& slices, double reachMm)
{
    const glm::ivec3 size = slices.geometry().size;
    VoxelRuns voxels;
    for (int k = 0; k < size.z; ++k) {
        const auto* contours = planeAt(planes, slices.heightOf(k), reachMm);
        if (!contours)
            continue;
        std::vector<SlicePolygon> polygons;
        for (const RtContour* contour : *contours)
            polygons.push_back(slices.polygonOn(k, *contour));
        const std::uint64_t slice = std::uint64_t(k) * std::uint64_t(size.y);
        fillPolygons(polygons, {size.x, size.y}, [&](int row, int from, int to) {
            voxels.append(
                (slice + std::uint64_t(row)) * std::uint64_t(size.x) + std::uint64_t(from),
                std::uint64_t(to - from));
        });
    }
    return voxels;
}

bool isClosed(const RtContour& contour)
{
    return contour.geometricType == QLatin1String("CLOSED_PLANAR")
        || contour.geometricType == QLatin1String("CLOSEDPLANAR_XOR");
}

/// Keeps the contours that surround something, without the first point once more at the end.
/// @return whether there were others
bool keepClosed(RtRoi& roi)
{
    for (RtContour& contour : roi.contours) {
        std::vector<glm::dvec3>& points = contour.points;
        while (points.size() > 1 && points.front() == points.back())
            points.pop_back();
    }
    return std::erase_if(roi.contours, [](const RtContour& contour) {
        return !isClosed(contour) || contour.points.size() < 3;
    }) != 0;
}

} // namespace

Result<MaskOnVolume> readContourMask(
    const QString& path, const Volume& volume, const Progress& progress)
{
    Result<RtStructFile> set = readRtStruct(path);
    if (!set)
        return tl::unexpected(set.error());
    std::set<int> withOthers; // regions, by their numbers
    QString frameOfReference;
    for (RtRoi& roi : set->rois) {
        if (keepClosed(roi))
            withOthers.insert(roi.number);
        if (frameOfReference.isEmpty())
            frameOfReference = roi.frameOfReferenceUid;
    }
    const Slices slices(volume.geometry);
    bool anyContour = false;
    for (const RtRoi& roi : set->rois) {
        for (const RtContour& contour : roi.contours) {
            anyContour = true;
            if (!slices.isFlat(contour))
                return failure(ErrorCode::UnsupportedFormat, path,
                    Clause::saying(
                        "contours of '%1' do not lie along the study's slices", roi.name));
        }
    }
    if (!anyContour)
        return failure(
            ErrorCode::UnsupportedFormat, path, Clause::saying("it has no closed contour"));
    MaskOnVolume mask;
    mask.notes = notesOnOrigin(set->patient.id, frameOfReference, volume);
    const Reach reach = reachOf(*set, slices);
    if (!reach.onSlices)
        mask.notes.push_back({.code = MaskNote::Code::BetweenSlices, .mm = reach.mm / 2.0});
    QStringList without;
    for (const RtRoi& roi : set->rois) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        const QString name = roi.name.simplified().isEmpty()
            ? QStringLiteral("ROI %1").arg(roi.number)
            : roi.name.simplified();
        VoxelRuns voxels = voxelsOf(planesOf(roi, slices), slices, reach.mm);
        if (voxels.empty()) {
            without += name;
            continue;
        }
        if (withOthers.contains(roi.number))
            mask.notes.push_back({.code = MaskNote::Code::OpenContours, .names = {name}});
        mask.segments.push_back(
            {.name = name, .rgb = roi.rgb, .code = roi.code, .voxels = std::move(voxels)});
    }
    if (!without.isEmpty() && !mask.segments.empty())
        mask.notes.push_back({.code = MaskNote::Code::NothingSurrounded, .names = without});
    return mask;
}

} // namespace core
