// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/SurfaceContour.h"

#include "gpu/render/parts/SurfaceBuffers.h"
#include "gpu/render/parts/SurfaceColour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gpu {

namespace {

constexpr float rimPixels = 1.0f; // beside the line
constexpr double marginPixels = 16.0; // lines so far outside of the frame are left out

constexpr double nearestDepth = 1e-3; // of the target's distance: nothing nearer is seen

/// A corner of a triangle: in the plane, and how far before it.
struct Corner {
    glm::dvec2 mm{0.0};
    double height = 0.0;
    glm::vec3 marks{0.0f};
};

std::array<std::uint8_t, 4> bytesOf(const glm::vec3& marks)
{
    const glm::vec3 bytes = glm::round(glm::clamp(marks, 0.0f, 1.0f) * 255.0f);
    return {std::uint8_t(bytes.x), std::uint8_t(bytes.y), std::uint8_t(bytes.z), 0};
}

class Plane {
public:
    explicit Plane(const SeenPlane& seen)
        : m_seen(seen)
        , m_normal(glm::cross(seen.rightLps, seen.downLps))
    {
    }
    [[nodiscard]] double heightOf(const glm::dvec3& lps) const
    {
        return glm::dot(lps - m_seen.centreLps, m_normal);
    }
    [[nodiscard]] glm::dvec2 mmOf(const glm::dvec3& lps) const
    {
        const glm::dvec3 from = lps - m_seen.centreLps;
        return {glm::dot(from, m_seen.rightLps), glm::dot(from, m_seen.downLps)};
    }
    /// Frame pixels times the depth, and the depth.
    [[nodiscard]] glm::dvec3 seenAt(const glm::dvec2& mm) const
    {
        return m_seen.pixelFromMm * glm::dvec3(mm, 1.0);
    }

private:
    const SeenPlane& m_seen;
    glm::dvec3 m_normal;
};

/// Where an edge of a triangle passes through the plane.
struct Crossing {
    glm::dvec2 mm{0.0};
    glm::vec3 marks{0.0f};
};

Crossing crossingOf(const Corner& one, const Corner& other)
{
    const double part = one.height / (one.height - other.height);
    return {.mm = glm::mix(one.mm, other.mm, part),
        .marks = glm::mix(one.marks, other.marks, float(part))};
}

/// @return nothing where all of the triangle lies on one side
std::optional<std::array<Crossing, 2>> cut(const std::array<const Corner*, 3>& triangle)
{
    std::array<Crossing, 2> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner& one = *triangle[i];
        const Corner& other = *triangle[(i + 1) % 3];
        if ((one.height < 0.0) == (other.height < 0.0))
            continue;
        // Two triangles have the same end, to the bit, on an edge between them.
        ends[count++] = one.height < other.height ? crossingOf(one, other) : crossingOf(other, one);
    }
    if (count != 2)
        return std::nullopt;
    return ends;
}

/// @return nothing where it lies behind the eye
std::optional<ContourLine> lineOf(const std::array<Crossing, 2>& ends, const Plane& plane)
{
    std::array<glm::dvec3, 2> seen{plane.seenAt(ends[0].mm), plane.seenAt(ends[1].mm)};
    if (seen[0].z < nearestDepth && seen[1].z < nearestDepth)
        return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::dvec3& other = seen[1 - i];
        if (seen[i].z < nearestDepth)
            seen[i] = glm::mix(other, seen[i], (other.z - nearestDepth) / (other.z - seen[i].z));
    }
    return ContourLine{.pixels = {glm::vec2(glm::dvec2(seen[0]) / seen[0].z),
                           glm::vec2(glm::dvec2(seen[1]) / seen[1].z)},
        .marks = {bytesOf(ends[0].marks), bytesOf(ends[1].marks)}};
}

bool isNear(const ContourLine& line, const glm::ivec2& frameSize)
{
    const glm::vec2 low = glm::min(line.pixels[0], line.pixels[1]);
    const glm::vec2 high = glm::max(line.pixels[0], line.pixels[1]);
    const glm::vec2 margin(marginPixels);
    return glm::all(glm::lessThan(low, glm::vec2(frameSize) + margin))
        && glm::all(glm::greaterThan(high, -margin));
}

float rimReach(const SceneContour& look, const PassTarget& target)
{
    return (0.5f * look.widthPixels + rimPixels) / target.pixelScale + 1.0f;
}

Tile reachOf(const std::vector<ContourLine>& lines, float margin, const PassTarget& target)
{
    if (lines.empty())
        return {};
    glm::vec2 low(1e9f);
    glm::vec2 high(-1e9f);
    for (const ContourLine& line : lines) {
        for (const glm::vec2& pixel : line.pixels) {
            low = glm::min(low, pixel);
            high = glm::max(high, pixel);
        }
    }
    const glm::vec2 frame(target.frameSize);
    const glm::ivec2 first(glm::floor(glm::max(low / target.pixelScale - margin, 0.0f)));
    const glm::ivec2 last(glm::ceil(glm::min(high / target.pixelScale + margin, frame)));
    return glm::all(glm::lessThan(first, last)) ? Tile{first, last - first} : Tile{};
}

} // namespace

std::vector<ContourLine> contourOf(
    const SurfaceBuffers& surface, const SeenPlane& seen, const glm::ivec2& frameSize)
{
    const Plane plane(seen);
    const auto positions = surface.positionsLps();
    const auto middles = surface.middlesLps();
    std::vector<double> heights;
    heights.reserve(positions.size());
    for (const glm::dvec3& position : positions)
        heights.push_back(plane.heightOf(position));

    std::vector<ContourLine> lines;
    std::vector<Corner> corners;
    for (std::size_t face = 0; face < surface.rings().size(); ++face) {
        const core::FaceRing& ring = surface.rings()[face];
        // The middle is the mean of the ring, so it lies between them.
        const auto isBehind = [&](core::VertexId id) { return heights[id] < 0.0; };
        const auto behind = std::count_if(ring.begin(), ring.end(), isBehind);
        if (behind == 0 || std::size_t(behind) == ring.size())
            continue;
        corners.clear();
        Corner middle{.mm = plane.mmOf(middles[face]), .height = plane.heightOf(middles[face])};
        for (const core::VertexId id : ring) {
            Corner corner{.mm = plane.mmOf(positions[id]), .height = heights[id]};
            corner.marks[int(surface.marks()[id])] = 1.0f;
            middle.marks += corner.marks / float(ring.size());
            corners.push_back(corner);
        }
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto ends = cut({&corners[i], &corners[(i + 1) % corners.size()], &middle});
            const auto line = ends ? lineOf(*ends, plane) : std::nullopt;
            if (line && isNear(*line, frameSize))
                lines.push_back(*line);
        }
    }
    return lines;
}

ContourPass::ContourPass(const ShaderLibrary& library)
    : m_cover(library,
        {.label = "contour",
            .vertexPath = "render/contourCover.vert",
            .fragmentPath = "render/contourCover.frag"})
    , m_lay(library, {.label = "contour over a slice", .fragmentPath = "render/contourLay.frag"})
{
}

void ContourPass::draw(ContourPicture& picture, const SurfaceBuffers& surface,
    const SeenPlane& plane, const SceneContour& look, const PassTarget& target)
{
    const std::vector<ContourLine> lines = contourOf(surface, plane, target.frameSize);
    const float reach = rimReach(look, target);
    picture.reach = reachOf(lines, reach, target);
    if (picture.isEmpty())
        return;
    if (!picture.cover || picture.cover.size() != target.frameSize) {
        picture.cover = Texture2D({.label = "cover of the contour", .size = target.frameSize});
        picture.frame = Framebuffer({.label = "contour", .colours = {&picture.cover}});
    }
    const std::size_t bytes = lines.size() * sizeof(ContourLine);
    if (picture.lines.bytes() < bytes) {
        picture.lines = Buffer({.label = "lines of the contour", .bytes = bytes + bytes / 2});
        picture.array.emplace("contour");
        picture.array->setVertices(picture.lines, sizeof(ContourLine));
        picture.array->setPerInstance();
        picture.array->setAttribute(0, {.components = 4, .offset = offsetof(ContourLine, pixels)});
        for (GLuint end = 0; end < 2; ++end)
            picture.array->setAttribute(1 + end,
                {.components = 4,
                    .type = GL_UNSIGNED_BYTE,
                    .normalized = true,
                    .offset = offsetof(ContourLine, marks) + 4 * end});
    }
    picture.lines.write(std::span<const ContourLine>(lines));

    m_cover.set("pixelScale", target.pixelScale)
        .set("texels", glm::vec2(picture.cover.size()))
        .set("halfWidth", 0.5f * look.widthPixels / target.pixelScale)
        .set("rim", rimPixels / target.pixelScale)
        .set("reach", reach);
    picture.frame.bind();
    glDisable(GL_SCISSOR_TEST);
    picture.frame.clear();
    glEnable(GL_BLEND);
    glBlendEquation(GL_MAX);
    m_cover.use();
    picture.array->drawQuads(int(lines.size()));
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
}

void ContourPass::lay(const ContourPicture& picture, const SceneContour& look, const Tile& tile,
    const VertexArray& noVertices)
{
    const glm::ivec2 low = glm::max(tile.minimum, picture.reach.minimum);
    const glm::ivec2 high =
        glm::min(tile.minimum + tile.size, picture.reach.minimum + picture.reach.size);
    if (!glm::all(glm::lessThan(low, high)))
        return;
    picture.cover.bindUnit(0);
    setMarkColours(m_lay, look.colours);
    glEnable(GL_SCISSOR_TEST);
    glScissor(low.x, low.y, high.x - low.x, high.y - low.y);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_lay.use();
    noVertices.drawFullScreenTriangle();
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
}

} // namespace gpu
