// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckExport.h"

#include "core/export/common/CheckSources.h"
#include "core/export/common/LabelMap.h"
#include "core/meshfile/MeshReader.h"
#include "core/volume/WorldToIndex.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace core {

namespace {

Result<ReadMesh> read(ExportFormat format, const QString& file)
{
    switch (format) {
    case ExportFormat::Obj:
        return readObj(file);
    case ExportFormat::Ply:
        return readPly(file);
    case ExportFormat::Gltf:
        return readGltf(file);
    default:
        return readStl(file);
    }
}

std::uint64_t mixed(std::uint64_t value)
{
    // splitmix64 (Steele, Lea and Flood 2014)
    value += 0x9E3779B97F4A7C15U;
    value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9U;
    value = (value ^ (value >> 27U)) * 0x94D049BB133111EBU;
    return value ^ (value >> 31U);
}

std::uint64_t numberOf(const glm::vec3& point)
{
    std::uint64_t number = 0;
    for (int axis = 0; axis < 3; ++axis)
        number = mixed(number ^ std::bit_cast<std::uint32_t>(point[axis]));
    return number;
}

/// Whether as many triangles run along each edge one way as the other; by their places, as STL has
/// nothing else. A sum of numbers made of both ends, which only cancels by pairs.
bool isClosed(const ReadMeshPart& part)
{
    std::array<std::uint64_t, 2> sum{};
    std::vector<std::uint64_t> numbers;
    numbers.reserve(part.vertices.size());
    for (const glm::vec3& vertex : part.vertices)
        numbers.push_back(numberOf(vertex));
    for (const glm::uvec3& triangle : part.triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::uint64_t a = numbers[triangle[i]];
            const std::uint64_t b = numbers[triangle[(i + 1) % 3]];
            const std::uint64_t edge = mixed(mixed(std::min(a, b)) + std::max(a, b));
            sum[0] += a < b ? edge : -edge;
            sum[1] += a < b ? mixed(edge) : -mixed(edge);
        }
    }
    return sum[0] == 0 && sum[1] == 0;
}

/// Millimetres in the file → index of the volume.
class ToIndex {
public:
    ToIndex(const VolumeGeometry& geometry, MeshSpace space)
        : m_turn(space == MeshSpace::Ras ? glm::dvec3(-1, -1, 1) : glm::dvec3(1))
        , m_toIndex(geometry)
    {
    }

    [[nodiscard]] glm::dvec3 operator()(const glm::vec3& point) const
    {
        return m_toIndex(m_turn * glm::dvec3(point));
    }

private:
    glm::dvec3 m_turn;
    WorldToIndex m_toIndex;
};

/// How often surfaces wind around each voxel's centre: rays along the slices' axis count what they
/// enter and leave.
class Winding {
public:
    explicit Winding(const glm::ivec3& size)
        : m_size(size)
        , m_entered(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0)
    {
    }

    void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    {
        const double area = cross(b - a, c - a);
        if (area == 0.0)
            return;
        const glm::dvec2 least = glm::min(glm::dvec2(a), glm::min(glm::dvec2(b), glm::dvec2(c)));
        const glm::dvec2 most = glm::max(glm::dvec2(a), glm::max(glm::dvec2(b), glm::dvec2(c)));
        const glm::ivec2 first = glm::max(glm::ivec2(0), glm::ivec2(glm::ceil(least - ray)));
        const glm::ivec2 last =
            glm::min(glm::ivec2(m_size) - 1, glm::ivec2(glm::floor(most - ray)));
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                const glm::dvec2 at = glm::dvec2(x, y) + ray;
                if (!isIn(a, b, at, area) || !isIn(b, c, at, area) || !isIn(c, a, at, area))
                    continue;
                const double u = cross(b - a, glm::dvec3(at, 0.0) - a) / area;
                const double v = cross(c - b, glm::dvec3(at, 0.0) - b) / area;
                const double z = a.z * v + b.z * (1.0 - u - v) + c.z * u;
                cross(x, y, z, area > 0.0 ? -1 : 1);
            }
        }
    }
    /// Sums up what was entered, once, after the last triangle.
    std::vector<std::int8_t> take()
    {
        const std::size_t slice = std::size_t(m_size.x) * std::size_t(m_size.y);
        for (std::size_t i = slice; i < m_entered.size(); ++i)
            m_entered[i] = std::int8_t(m_entered[i] + m_entered[i - slice]);
        return std::move(m_entered);
    }

private:
    /// A little beside the centres, where corners and edges of an unsmoothed surface lie; much less
    /// than the surface keeps away from a centre.
    static constexpr glm::dvec2 ray{0.0137, 0.0071};

    static double cross(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.y - a.y * b.x; }
    /// On the inner side of an edge; the two triangles at it never both say so, nor neither.
    static bool isIn(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec2& at, double area)
    {
        const bool turned = a.x != b.x ? a.x > b.x : a.y > b.y;
        const glm::dvec3& from = turned ? b : a;
        const glm::dvec3& to = turned ? a : b;
        const bool left = cross(to - from, glm::dvec3(at, 0.0) - from) >= 0.0;
        return left == ((area > 0.0) != turned);
    }
    void cross(int x, int y, double z, int sign)
    {
        const int k = z < 0.0 ? 0 : z >= m_size.z ? m_size.z : int(std::floor(z)) + 1;
        if (k >= m_size.z)
            return;
        const std::size_t at =
            (std::size_t(k) * std::size_t(m_size.y) + std::size_t(y)) * std::size_t(m_size.x)
            + std::size_t(x);
        m_entered[at] = std::int8_t(m_entered[at] + sign);
    }

    glm::ivec3 m_size;
    std::vector<std::int8_t> m_entered;
};

/// How many voxels lie in the part more or less often than in the segments.
Result<std::size_t> wrongVoxels(const ReadMeshPart& part, std::span<const Segment> segments,
    const ExportExpectation& expected, const ToIndex& toIndex, const Progress& progress)
{
    Winding winding(expected.volume.geometry.size);
    // Where the index axes are left-handed so is what is seen there.
    const bool mirrored = glm::determinant(glm::dmat3(expected.volume.geometry.indexToWorld)) < 0.0;
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
        if (i % 65536 == 0 && progress.cancelled())
            return failure(ErrorCode::Cancelled);
        const glm::uvec3& triangle = part.triangles[i];
        const glm::dvec3 a = toIndex(part.vertices[triangle.x]);
        const glm::dvec3 b = toIndex(part.vertices[triangle.y]);
        const glm::dvec3 c = toIndex(part.vertices[triangle.z]);
        mirrored ? winding.add(a, c, b) : winding.add(a, b, c);
    }
    std::vector<std::int8_t> found = winding.take();
    for (const Segment& segment : segments) {
        for (const LabelPlaneView& plane : expected.planes) {
            for (std::size_t i = 0; plane.plane == segment.plane && i < found.size(); ++i)
                found[i] = std::int8_t(found[i] - (plane.labels[i] == segment.label ? 1 : 0));
        }
    }
    return std::size_t(
        std::count_if(found.begin(), found.end(), [](std::int8_t rest) { return rest != 0; }));
}

QString plainName(const QString& name)
{
    QString plain = name;
    for (QChar& character : plain) {
        if (character.category() == QChar::Other_Control)
            character = u' ';
    }
    plain = plain.simplified();
    return plain.isEmpty() ? QStringLiteral("Segment") : plain;
}

/// What of a part is not its segment's, as a word; empty if all is.
Clause differenceOfPart(const ReadMeshPart& part, const Segment& segment)
{
    if (part.name != plainName(segment.name))
        return Clause::saying("its name");
    if (part.rgb != (segment.rgb & 0xffffffU))
        return Clause::saying("its colour");
    if (part.label && *part.label != segment.label)
        return Clause::saying("its label");
    return {};
}

} // namespace

Result<ReportLines> checkSurfaceExport(ExportFormat format, const QString& file,
    const ExportExpectation& expected, const Progress& progress)
{
    const auto mismatch = [&](const Clause& what) {
        return failure(ErrorCode::ExportMismatch, file, what);
    };
    const auto mesh = read(format, file);
    if (!mesh)
        return tl::unexpected(mesh.error());
    const QString space =
        expected.space == MeshSpace::Ras ? QStringLiteral("RAS") : QStringLiteral("LPS");
    if (mesh->space != space)
        return mismatch(Clause::saying("it does not say that its axes are %1", space));
    const bool inOne = format == ExportFormat::Stl;
    if (mesh->parts.size() != (inOne ? 1 : expected.segments.size()))
        return mismatch(Clause::saying("the number of segments"));
    if (const auto place = labelMapPlace(file, expected.volume, progress); !place)
        return tl::unexpected(place.error());
    const ToIndex toIndex(expected.volume.geometry, expected.space);
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < mesh->parts.size(); ++i) {
        progress.report(ProgressStep::CheckingSurfaces, int(i), int(mesh->parts.size()));
        const ReadMeshPart& part = mesh->parts[i];
        const std::span<const Segment> segments =
            inOne ? std::span(expected.segments) : std::span(expected.segments).subspan(i, 1);
        const Clause what = inOne ? Clause() : differenceOfPart(part, segments[0]);
        if (!what.isEmpty())
            return mismatch(Clause::saying("segment '%1': %2", segments[0].name, what));
        if (!isClosed(part))
            return mismatch(Clause::saying("a surface is not closed"));
        const auto wrong = wrongVoxels(part, segments, expected, toIndex, progress);
        if (!wrong)
            return tl::unexpected(wrong.error());
        if (*wrong != 0)
            return mismatch(Clause::saying("%1 voxels are not as drawn", *wrong));
        triangles += part.triangles.size();
    }
    return ReportLines{ReportSentence{ReportCode::TrianglesClosed, {std::int64_t(triangles)}},
        ReportSentence{ReportCode::CentresInside,
            {countedInReport(ReportCode::Segments, std::int64_t(expected.segments.size()))}}};
}

} // namespace core
