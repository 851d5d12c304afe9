// SPDX-License-Identifier: Apache-2.0
#include "core/contour/ContourEvolution.h"

#include "core/volume/MemoryLimit.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

namespace core {

namespace {

std::size_t voxelsOf(const VoxelBox& box)
{
    const glm::ivec3 extent = box.maximum - box.minimum;
    return std::size_t(extent.x) * std::size_t(extent.y) * std::size_t(extent.z);
}

// Numbers of voxels between two checks whether the work was cancelled.
constexpr std::size_t askedBetweenLooks = 4096;
constexpr std::size_t lookedAtBetweenLooks = 65536;

} // namespace

glm::ivec3 contourMargin(const ContourKernel& kernel)
{
    return kernel.extent + 1; // g of the last voxel of the kernel reads its neighbours' codes
}

VoxelBox contourBox(const VoxelBox& start, int generations, const ContourKernel& kernel,
    const glm::ivec3& volumeSize)
{
    const glm::ivec3 around = contourMargin(kernel) + generations;
    return {.minimum = glm::max(start.minimum - around, glm::ivec3(0)),
        .maximum = glm::min(start.maximum + around, volumeSize)};
}

Result<void> checkContourMemory(const VoxelBox& box)
{
    const std::size_t voxels = voxelsOf(box);
    constexpr double bytesPerVoxel = 4.0; // code, flags, g
    const Clause what = Clause::saying("the box in which the contour evolves");
    if (voxels > std::numeric_limits<std::uint32_t>::max())
        return failure(ErrorCode::OutOfMemory, Clause::saying("%1 has more than 2³² voxels", what));
    return checkBytes(bytesPerVoxel * double(voxels), what);
}

ContourEvolution::ContourEvolution(ContourRule rule, ContourGround ground)
    : m_rule(std::move(rule))
    , m_ground(std::move(ground))
    , m_extent(m_ground.box.maximum - m_ground.box.minimum)
    , m_period(glm::max(m_rule.kernel.extent, glm::ivec3(1)) + 1)
    , m_strides{1, m_extent.x, std::int64_t(m_extent.x) * m_extent.y}
    , m_edges(m_ground.voxels.size(), 0)
{
    for (const ContourKernel::Step& step : m_rule.kernel.steps)
        m_steps.push_back(
            step.to.x * m_strides[0] + step.to.y * m_strides[1] + step.to.z * m_strides[2]);
}

glm::ivec3 ContourEvolution::voxelAt(Place place) const
{
    const auto columns = Place(m_extent.x);
    const auto rows = Place(m_extent.y);
    return m_ground.box.minimum
        + glm::ivec3(
            int(place % columns), int(place / columns % rows), int(place / columns / rows));
}

/// Visits the six neighbours within the box, or the eighteen if @p isWide. For a voxel that the
/// contour can reach, the box contains all neighbours that lie in the volume.
template <class Visit>
void ContourEvolution::visitNeighbours(Place place, bool isWide, Visit&& visit) const
{
    const glm::ivec3 voxel = voxelAt(place);
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t stride = m_strides[std::size_t(axis)];
        if (voxel[axis] > m_ground.box.minimum[axis])
            visit(Place(place - stride));
        if (voxel[axis] + 1 < m_ground.box.maximum[axis])
            visit(Place(place + stride));
    }
    if (!isWide)
        return;
    const auto leads = [&](int axis, int to) {
        return voxel[axis] + to >= m_ground.box.minimum[axis]
            && voxel[axis] + to < m_ground.box.maximum[axis];
    };
    for (const auto& [one, other] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
        for (const int along : {-1, 1}) {
            for (const int across : {-1, 1}) {
                if (leads(one, along) && leads(other, across))
                    visit(Place(place + along * m_strides[std::size_t(one)]
                        + across * m_strides[std::size_t(other)]));
            }
        }
    }
}

bool ContourEvolution::isAtFront(Place place, bool isWide) const
{
    const std::uint8_t own = m_ground.voxels[place];
    if (!(own & ContourGround::open))
        return false;
    bool isThere = false;
    visitNeighbours(place, isWide, [&](Place next) {
        const std::uint8_t other = m_ground.voxels[next];
        isThere = isThere
            || (((other ^ own) & ContourGround::inside) && !(other & ContourGround::absent));
    });
    return isThere;
}

int ContourEvolution::codeNear(glm::ivec3 voxel) const
{
    voxel = glm::clamp(voxel, glm::ivec3(0), m_ground.volumeSize - 1) - m_ground.box.minimum;
    return m_ground.codes[std::size_t(
        voxel.x * m_strides[0] + voxel.y * m_strides[1] + voxel.z * m_strides[2])];
}

int ContourEvolution::edgeAt(Place place)
{
    std::uint8_t& edge = m_edges[place];
    if (edge != 0)
        return edge;
    std::uint64_t squared = 0;
    if (m_rule.edge > 0) {
        constexpr std::int64_t unit = 1024;
        constexpr std::int64_t greatest = 32767;
        const glm::ivec3 voxel = voxelAt(place);
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 step(0);
            step[axis] = 1;
            const std::int64_t difference =
                std::abs(codeNear(voxel + step) - codeNear(voxel - step));
            const std::int64_t part =
                std::min(m_rule.gradientWeights[axis] * difference / unit, greatest);
            squared += std::uint64_t(part * part);
        }
    }
    edge = std::uint8_t(edgeWeight(m_rule, squared));
    return edge;
}

bool ContourEvolution::wantsOtherSide(Place place)
{
    const std::vector<ContourKernel::Step>& steps = m_rule.kernel.steps;
    const std::int64_t region = std::int64_t(m_rule.region) * m_rule.kernel.total
        * regionSpeed(m_rule, m_ground.codes[place]);
    std::int64_t around = 0;
    if (m_rule.smoothness > 0) {
        const glm::ivec3 voxel = voxelAt(place);
        const glm::ivec3& reach = m_rule.kernel.extent;
        const bool isDeep = glm::all(glm::greaterThanEqual(voxel, reach))
            && glm::all(glm::lessThan(voxel + reach, m_ground.volumeSize));
        const int edge = edgeAt(place);
        for (std::size_t each = 0; each < steps.size(); ++each) {
            const glm::ivec3 to = voxel + steps[each].to;
            if (!isDeep
                && (glm::any(glm::lessThan(to, glm::ivec3(0)))
                    || glm::any(glm::greaterThanEqual(to, m_ground.volumeSize))))
                continue;
            const auto next = Place(place + m_steps[each]);
            if (m_ground.voxels[next] & ContourGround::absent)
                continue;
            const int weight = steps[each].weight * (edge + edgeAt(next));
            around += m_ground.voxels[next] & ContourGround::inside ? weight : -weight;
        }
    }
    const std::int64_t speed = region + m_rule.smoothness * around;
    return m_ground.voxels[place] & ContourGround::inside ? speed < 0 : speed > 0;
}

std::size_t ContourEvolution::classOf(Place place) const
{
    const glm::ivec3 in = voxelAt(place) % m_period;
    return std::size_t(in.x + m_period.x * (in.y + m_period.y * in.z));
}

/// Finds the front among the voxels of the segment and their neighbours.
bool ContourEvolution::findFront(const Progress& progress)
{
    const auto come = [this](Place place) { comeToFront(place); };
    for (std::size_t place = 0; place < m_ground.voxels.size(); ++place) {
        if (place % lookedAtBetweenLooks == 0 && progress.cancelled())
            return false; // what was found stays found
        if (!(m_ground.voxels[place] & ContourGround::inside))
            continue;
        come(Place(place));
        visitNeighbours(Place(place), m_rule.round, come);
    }
    m_frontKnown = true;
    return true;
}

void ContourEvolution::comeToFront(Place place)
{
    if (!(m_ground.voxels[place] & atFront) && isAtFront(place, m_rule.round)) {
        m_ground.voxels[place] |= atFront;
        m_front.push_back(place);
    }
}

/// To be called after voxels were changed: only they and their neighbours can come to the front or
/// leave it.
void ContourEvolution::moveFront(std::span<const Place> changed)
{
    const auto come = [this](Place place) { comeToFront(place); };
    for (const Place place : changed) {
        come(place);
        visitNeighbours(place, m_rule.round, come);
    }
    const auto left = [this](Place place) {
        if (isAtFront(place, m_rule.round))
            return false;
        m_ground.voxels[place] &= std::uint8_t(~atFront);
        return true;
    };
    m_front.erase(std::remove_if(m_front.begin(), m_front.end(), left), m_front.end());
}

bool ContourEvolution::ask(bool isWide, std::vector<Place>& changed, const Progress& progress)
{
    std::vector<std::vector<Place>> classes(
        std::size_t(m_period.x) * std::size_t(m_period.y) * std::size_t(m_period.z));
    const bool isPart = m_rule.round && !isWide; // of those that are kept
    for (const Place place : m_front) {
        if (!isPart || isAtFront(place, isWide))
            classes[classOf(place)].push_back(place);
    }
    const auto flipFrom = [&](std::size_t first) {
        for (std::size_t each = first; each < changed.size(); ++each)
            m_ground.voxels[changed[each]] ^= ContourGround::inside;
    };
    std::size_t asked = 0;
    for (const std::vector<Place>& alike : classes) {
        const std::size_t before = changed.size();
        for (const Place place : alike) {
            if (++asked % askedBetweenLooks == 0 && progress.cancelled()) {
                changed.resize(before);
                flipFrom(0);
                return false;
            }
            if (isAtFront(place, isWide) && wantsOtherSide(place))
                changed.push_back(place);
        }
        flipFrom(before);
    }
    return true;
}

bool ContourEvolution::step(const Progress& progress)
{
    if (!m_frontKnown && !findFront(progress))
        return false;
    const bool isEven = (m_generation + 1) % 2 == 0;
    const bool isWide = m_rule.round && isEven;
    std::vector<Place> changed;
    if (!ask(isWide, changed, progress))
        return false;
    if (changed.empty() && m_rule.round && !isWide && !ask(true, changed, progress))
        return false;
    m_rests = changed.empty();
    if (m_rests)
        return false;
    moveFront(changed);
    changed.shrink_to_fit(); // somebody may keep it for long
    m_lastChanged = std::make_shared<const std::vector<Place>>(std::move(changed));
    ++m_generation;
    return true;
}

bool ContourEvolution::isInside(const glm::ivec3& voxel) const
{
    const glm::ivec3 at = voxel - m_ground.box.minimum;
    return m_ground
               .voxels[std::size_t(at.x * m_strides[0] + at.y * m_strides[1] + at.z * m_strides[2])]
        & ContourGround::inside;
}

ShapeChange ContourEvolution::change() const
{
    ShapeChange change;
    const VoxelBox& box = m_ground.box;
    std::size_t place = 0;
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            std::uint64_t number = std::uint64_t(box.minimum.x)
                + std::uint64_t(m_ground.volumeSize.x)
                    * (std::uint64_t(y) + std::uint64_t(m_ground.volumeSize.y) * std::uint64_t(z));
            for (int x = box.minimum.x; x < box.maximum.x; ++x, ++place, ++number) {
                const bool isIn = m_ground.voxels[place] & ContourGround::inside;
                const bool wasIn = m_ground.voxels[place] & ContourGround::own;
                if (isIn != wasIn)
                    (isIn ? change.given : change.taken).append(number, 1);
            }
        }
    }
    return change;
}

} // namespace core
