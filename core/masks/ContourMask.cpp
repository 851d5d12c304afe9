// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/RtStructFile.h"
#include "core/masks/MaskParts.h"
#include "core/masks/PolygonFill.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
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
    /// Of a contour: the mean over its points, since each is rounded for itself. Heights may be so
    /// great that their sum is no number, but not their differences.
    [[nodiscard]] double heightOf(const RtContour& contour) const
    {
        const double first = heightOf(contour.points.front());
        double off = 0.0;
        for (const glm::dvec3& point : contour.points)
            off += heightOf(point) - first;
        return first + off / double(contour.points.size());
    }
    /// Lies in a plane along the slices.
    [[nodiscard]] bool isFlat(const RtContour& contour) const
    {
        const double height = heightOf(contour);
        return std::all_of(contour.points.begin(), contour.points.end(), [&](const auto& point) {
            return std::abs(heightOf(point) - height) <= std::max(0.01, 0.1 * m_stepMm);
        });
    }
    /// How far the heights of contours of one plane may lie apart: as far as coordinates with one
    /// decimal scatter, but well below the step of the slices.
    [[nodiscard]] double sameMm() const
    {
        return std::min(std::clamp(0.1 * m_stepMm, 0.02, 0.1), 0.3 * m_stepMm);
    }
    /// None: it lies on no slice.
    [[nodiscard]] std::optional<int> sliceAt(double height) const
    {
        const auto nearest =
            std::min_element(m_heights.begin(), m_heights.end(), [&](double one, double other) {
                return std::abs(one - height) < std::abs(other - height);
            });
        if (std::abs(*nearest - height) > std::max({0.01, 0.01 * m_stepMm, sameMm()}))
            return std::nullopt;
        return int(nearest - m_heights.begin());
    }
    /// How far a height lies beyond the first or last slice and the half step that is theirs; 0: it
    /// does not.
    [[nodiscard]] double beyondMm(double height) const
    {
        const auto [low, high] = std::minmax_element(m_heights.begin(), m_heights.end());
        return std::max({0.0, *low - m_stepMm / 2.0 - height, height - *high - m_stepMm / 2.0});
    }
    /// The first or the last one.
    [[nodiscard]] int endNear(double height) const
    {
        const double first = std::abs(m_heights.front() - height);
        return first < std::abs(m_heights.back() - height) ? 0 : count() - 1;
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

/// Contours of one plane, by its height in thousandths of a mm along the normal.
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

/// The planes in which the contours of a file lie, of all its regions together: a region with one
/// contour in a plane must not have another plane than its neighbour. Coordinates are rounded in
/// files, to one or two decimals in many, so that on oblique slices contours of one plane have
/// different heights.
class DrawnPlanes {
public:
    DrawnPlanes(const RtStructFile& set, const Slices& slices)
        : m_slices(slices)
    {
        std::vector<double> heights;
        bool anyOnSlice = false;
        bool anyBetween = false;
        for (const RtRoi& roi : set.rois) {
            for (const RtContour& contour : roi.contours) {
                heights.push_back(slices.heightOf(contour));
                const bool onSlice = slices.sliceAt(heights.back()).has_value();
                anyOnSlice = anyOnSlice || onSlice;
                anyBetween = anyBetween || (!onSlice && slices.beyondMm(heights.back()) == 0.0);
            }
        }
        m_onSlices = anyOnSlice && !anyBetween;
        if (m_onSlices)
            std::erase_if(
                heights, [&](double height) { return slices.sliceAt(height).has_value(); });
        // Each is reckoned from the lowest of its contours, so that no chain of them joins planes.
        std::sort(heights.begin(), heights.end());
        for (auto first = heights.begin(); first != heights.end();) {
            const auto end = std::find_if(first, heights.end(),
                [&](double height) { return height - *first > slices.sameMm(); });
            m_planes.push_back({.from = *first, .height = *first + (*(end - 1) - *first) / 2.0});
            first = end;
        }
    }

    /// Whether all that lie within the study lie on its slices; each is its slice's then, and no
    /// other's.
    [[nodiscard]] bool onSlices() const { return m_onSlices; }
    [[nodiscard]] Planes of(const RtRoi& roi) const
    {
        Planes planes;
        for (const RtContour& contour : roi.contours)
            planes[thousandthsOf(planeOf(m_slices.heightOf(contour)))].push_back(&contour);
        return planes;
    }
    /// How far a plane reaches: half of it to each side.
    [[nodiscard]] double reachMm() const
    {
        if (m_onSlices || m_planes.size() < 2)
            return m_slices.stepMm();
        std::vector<double> steps;
        for (std::size_t i = 1; i < m_planes.size(); ++i)
            steps.push_back(
                mmOf(thousandthsOf(m_planes[i].height) - thousandthsOf(m_planes[i - 1].height)));
        std::erase_if(steps, [](double step) { return !(step > 0.0); });
        if (steps.empty())
            return m_slices.stepMm();
        const double least = *std::min_element(steps.begin(), steps.end());
        // Steps that rounding alone makes different must leave no slice between them out.
        double reach = least;
        for (const double step : steps)
            reach = step <= least + m_slices.sameMm() ? std::max(reach, step) : reach;
        return reach;
    }

private:
    struct Plane {
        double from; ///< height of its lowest contour
        double height;
    };

    [[nodiscard]] double planeOf(double height) const
    {
        const std::optional<int> slice = m_onSlices ? m_slices.sliceAt(height) : std::nullopt;
        if (slice)
            return m_slices.heightOf(*slice);
        const auto next = std::upper_bound(m_planes.begin(), m_planes.end(), height,
            [](double value, const Plane& plane) { return value < plane.from; });
        return std::prev(next)->height;
    }

    const Slices& m_slices;
    bool m_onSlices = false;
    std::vector<Plane> m_planes; ///< ascending; without those that are slices
};

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

/// What a region surrounds.
struct Surrounded {
    VoxelRuns voxels;
    /// Voxels beyond the study, as if its slices went on; not whole where planes are thinner.
    double outside = 0.0;
};

std::vector<SlicePolygon> polygonsOn(
    int k, const std::vector<const RtContour*>& contours, const Slices& slices)
{
    std::vector<SlicePolygon> polygons;
    for (const RtContour* contour : contours)
        polygons.push_back(slices.polygonOn(k, *contour));
    return polygons;
}

bool areInside(const std::vector<SlicePolygon>& polygons, const glm::ivec2& size)
{
    const glm::ivec2 last = (size - 1) << SlicePolygon::bits;
    return std::all_of(polygons.begin(), polygons.end(), [&](const SlicePolygon& polygon) {
        return std::all_of(polygon.points.begin(), polygon.points.end(), [&](const auto& point) {
            return glm::all(glm::greaterThanEqual(point, glm::ivec2(0)))
                && glm::all(glm::lessThanEqual(point, last));
        });
    });
}

Surrounded surroundedBy(const Planes& planes, const Slices& slices, const DrawnPlanes& drawn)
{
    const glm::ivec3 size = slices.geometry().size;
    const double reachMm = drawn.reachMm();
    Surrounded made;
    for (int k = 0; k < size.z; ++k) {
        const auto* contours = planeAt(planes, slices.heightOf(k), reachMm);
        if (!contours)
            continue;
        const std::vector<SlicePolygon> polygons = polygonsOn(k, *contours, slices);
        const std::uint64_t slice = std::uint64_t(k) * std::uint64_t(size.y);
        std::uint64_t inside = 0;
        fillPolygons(polygons, {size.x, size.y}, [&](int row, int from, int to) {
            made.voxels.append(
                (slice + std::uint64_t(row)) * std::uint64_t(size.x) + std::uint64_t(from),
                std::uint64_t(to - from));
            inside += std::uint64_t(to - from);
        });
        if (!areInside(polygons, {size.x, size.y}))
            made.outside += double(surroundedPixels(polygons, {size.x, size.y})) - double(inside);
    }
    for (const auto& [height, contours] : planes) {
        const double beyondMm = slices.beyondMm(mmOf(height));
        if (beyondMm == 0.0)
            continue;
        // Of a plane that reaches into the study, what lies beyond it.
        const double outMm = std::min(reachMm, beyondMm + reachMm / 2.0);
        const auto polygons = polygonsOn(slices.endNear(mmOf(height)), contours, slices);
        made.outside += double(surroundedPixels(polygons, {size.x, size.y}))
            * (drawn.onSlices() ? 1.0 : outMm / slices.stepMm());
    }
    return made;
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
    const DrawnPlanes drawn(*set, slices);
    if (!drawn.onSlices())
        mask.notes.push_back({.code = MaskNote::Code::BetweenSlices, .mm = drawn.reachMm() / 2.0});
    QStringList without;
    std::uint64_t inside = 0;
    double outside = 0.0;
    for (const RtRoi& roi : set->rois) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        const QString name = roi.name.simplified().isEmpty()
            ? QStringLiteral("ROI %1").arg(roi.number)
            : roi.name.simplified();
        auto [voxels, beyond] = surroundedBy(drawn.of(roi), slices, drawn);
        inside += voxels.voxelCount();
        outside += beyond;
        if (voxels.empty()) {
            without += name;
            continue;
        }
        if (withOthers.contains(roi.number))
            mask.notes.push_back({.code = MaskNote::Code::OpenContours, .names = {name}});
        mask.segments.push_back(
            {.name = name, .rgb = roi.rgb, .code = roi.code, .voxels = std::move(voxels)});
    }
    // A file may have planes so far apart that no whole number holds what lies between them.
    constexpr double most = 1e15;
    const auto left = std::uint64_t(std::llround(std::min(outside, most)));
    if (left != 0)
        mask.notes.push_back(
            {.code = MaskNote::Code::OutsideStudy, .some = left, .all = inside + left});
    if (!without.isEmpty() && !mask.segments.empty())
        mask.notes.push_back({.code = MaskNote::Code::NothingSurrounded, .names = without});
    return mask;
}

} // namespace core
