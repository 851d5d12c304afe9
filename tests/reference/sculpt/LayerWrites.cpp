// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/sculpt/LayerWrites.h"

#include "core/growth/SeedWord.h"
#include "tests/reference/growth/Growth.h"

#include <algorithm>
#include <cstdlib>

namespace reference {

namespace seedWord = core::seedWord;

namespace {

template <class Visit> void forEachVoxel(const glm::ivec3& size, Visit visit)
{
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z));
}

void give(DenseFields& fields, const core::LabelTarget& target, const glm::ivec3& voxel)
{
    std::uint8_t& held = fields.labels(target.plane).at(voxel);
    if (held != 0 && held != target.label && !target.overwritable[held])
        return;
    held = target.label;
    std::uint32_t& word = fields.seedWords(target.plane).at(voxel);
    const bool bears = seedWord::isMember(word) || seedWord::isPendingSeed(word);
    if (bears && seedWord::label(word) != target.label)
        word = seedWord::unvisited;
}

void take(DenseFields& fields, const core::LabelTarget& target, const glm::ivec3& voxel)
{
    std::uint8_t& held = fields.labels(target.plane).at(voxel);
    if (held == target.label)
        held = 0;
    std::uint32_t& word = fields.seedWords(target.plane).at(voxel);
    const bool bears = seedWord::isMember(word) || seedWord::isPendingSeed(word);
    if (bears && seedWord::label(word) == target.label)
        word = seedWord::unvisited;
}

bool within(const std::vector<core::VoxelBound>& bounds, const glm::ivec3& voxel)
{
    return std::all_of(bounds.begin(), bounds.end(), [&voxel](const core::VoxelBound& bound) {
        std::int64_t sum = 0;
        for (int axis = 0; axis < 3; ++axis)
            sum += std::int64_t(bound.normal[axis]) * voxel[axis];
        return sum <= bound.offset;
    });
}

/// How many edges pass above a place to the right, less how many to the left, is how often the
/// outline winds around it. A place on an edge counts as inside.
bool outlineHolds(const std::vector<glm::ivec2>& corners, std::int64_t x, std::int64_t y)
{
    constexpr std::int64_t farAway = std::int64_t(1) << 30; // farther than any corner
    if (std::abs(x) > farAway || std::abs(y) > farAway)
        return false;
    int winding = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::ivec2& next = corners[(i + 1) % corners.size()];
        const std::int64_t fromX = corners[i].x - x;
        const std::int64_t fromY = corners[i].y - y;
        const std::int64_t toX = next.x - x;
        const std::int64_t toY = next.y - y;
        const std::int64_t turn = fromX * toY - fromY * toX;
        if (turn == 0 && fromX * toX + fromY * toY <= 0)
            return true;
        if (fromX < 0 && toX >= 0 && turn < 0)
            ++winding;
        if (fromX >= 0 && toX < 0 && turn > 0)
            --winding;
    }
    return winding != 0;
}

bool holdsOneOf(const std::vector<core::EditableVoxels::PlaneLabels>& listed, DenseFields& fields,
    const glm::ivec3& voxel)
{
    bool holds = false;
    for (const core::EditableVoxels::PlaneLabels& each : listed) {
        const std::uint8_t label = fields.labels(each.plane).at(voxel);
        holds = holds || (label != 0 && each.labels[label]);
    }
    return holds;
}

} // namespace

bool isEditable(const std::optional<core::EditableVoxels>& editable,
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const glm::ivec3& voxel)
{
    if (!editable)
        return true;
    const int code = codes.at(voxel);
    bool is = code >= editable->lowCode && code <= editable->highCode;
    for (int axis = 0; axis < 3 && editable->box; ++axis)
        is = is && editable->box->minimum[axis] <= voxel[axis]
            && editable->box->maximum[axis] > voxel[axis];
    if (editable->inside)
        is = is && holdsOneOf(*editable->inside, fields, voxel);
    return is && !holdsOneOf(editable->outside, fields, voxel);
}

void labelCarved(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::LabelCarved& edit)
{
    const DenseArray<std::uint8_t> coverage = fields.coverage(edit.layer);
    forEachVoxel(fields.size(), [&](const glm::ivec3& voxel) {
        if (coverage.at(voxel) >= 128 && isEditable(edit.editable, codes, fields, voxel))
            give(fields, edit.target, voxel);
    });
}

void labelSeen(const DenseArray<std::uint16_t>& codes, const DenseArray<std::uint8_t>& carved,
    DenseFields& fields, const core::LabelSeen& edit)
{
    forEachVoxel(fields.size(), [&](const glm::ivec3& voxel) {
        const int code = codes.at(voxel);
        if (carved.at(voxel) < 128 && code >= edit.lowCode && code <= edit.highCode
            && within(edit.bounds, voxel) && isEditable(edit.editable, codes, fields, voxel))
            give(fields, edit.target, voxel);
    });
}

void labelListed(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::LabelListed& edit)
{
    const core::BrickGrid grid{fields.size()};
    for (const core::LabelListed::Brick& brick : edit.bricks) {
        const core::VoxelBox box = grid.boxOf(int(brick.brick));
        forEachVoxel(box.maximum - box.minimum, [&](const glm::ivec3& within) {
            const glm::ivec3 voxel = box.minimum + within;
            if (!isEditable(edit.editable, codes, fields, voxel))
                return;
            const std::uint8_t asked =
                brick.labels[std::size_t(core::BrickGrid::offsetInBrick(voxel))];
            const std::uint8_t held = fields.labels(edit.plane).at(voxel);
            if (asked != 0 && asked != edit.frees)
                give(fields, {edit.plane, asked, edit.overwritable}, voxel);
            else if (asked != 0 && held != 0 && edit.overwritable[held])
                take(fields, {.plane = edit.plane, .label = held}, voxel);
        });
    }
}

void labelPlanes(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::LabelPlanes& edit)
{
    for (const core::LabelListed& plane : edit.planes)
        labelListed(codes, fields, plane);
}

void relabelListed(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::RelabelListed& edit)
{
    forEachVoxel(fields.size(), [&](const glm::ivec3& voxel) {
        if (!isEditable(edit.editable, codes, fields, voxel))
            return;
        for (const core::RelabelListed::Brick& brick : edit.bricks) {
            if (int(brick.brick) != core::BrickGrid{fields.size()}.brickOf(voxel))
                continue;
            const int asked = brick.asked[std::size_t(core::BrickGrid::offsetInBrick(voxel))];
            if (asked == core::RelabelListed::give)
                give(fields, edit.target, voxel);
            else if (asked == core::RelabelListed::take)
                take(fields, edit.target, voxel);
        }
    });
}

void labelOutlined(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::LabelOutlined& edit)
{
    forEachVoxel(fields.size(), [&](const glm::ivec3& voxel) {
        const auto along = [&](std::size_t axis) {
            const std::int64_t place = edit.origin[axis] + edit.perI[axis] * voxel.x
                + edit.perJ[axis] * voxel.y + edit.perK[axis] * voxel.z;
            return core::fixedPoint::round14(place);
        };
        const int code = codes.at(voxel);
        if (std::abs(along(2)) > edit.halfThickness || code < edit.lowCode || code > edit.highCode
            || !outlineHolds(edit.corners, along(0), along(1))
            || !isEditable(edit.editable, codes, fields, voxel))
            return;
        if (edit.erase)
            take(fields, edit.target, voxel);
        else
            give(fields, edit.target, voxel);
    });
}

void labelThreshold(const DenseArray<std::uint16_t>& codes, const DenseArray<std::uint8_t>& carved,
    DenseFields& fields, const core::LabelThreshold& edit)
{
    using How = core::LabelThreshold::How;
    forEachVoxel(fields.size(), [&](const glm::ivec3& voxel) {
        for (int axis = 0; axis < 3; ++axis) {
            if (edit.box
                && (voxel[axis] < edit.box->minimum[axis]
                    || voxel[axis] >= edit.box->maximum[axis]))
                return;
        }
        if (edit.onlyVisible && carved.at(voxel) >= 128)
            return;
        if (!isEditable(edit.editable, codes, fields, voxel))
            return;
        const int code = codes.at(voxel);
        const bool chosen = edit.lowCode <= code && code <= edit.highCode;
        if (chosen && edit.how != How::Subtract)
            give(fields, edit.target, voxel);
        else if (chosen || edit.how == How::Replace)
            take(fields, edit.target, voxel);
    });
}

void mapLabels(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::MapLabels& edit)
{
    std::bitset<256> all;
    all.set();
    forEachVoxel(fields.size(), [&](const glm::ivec3& voxel) {
        const std::uint8_t held = fields.labels(edit.plane).at(voxel);
        const std::uint8_t next = edit.becomes[held];
        if (!isEditable(edit.editable, codes, fields, voxel))
            return;
        if (next != held && next != 0)
            give(fields, {edit.plane, next, all}, voxel);
        else if (next != held)
            take(fields, {edit.plane, held, {}}, voxel);
    });
}

void mapPlanes(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::MapPlanes& edit)
{
    for (const core::MapLabels& plane : edit.planes)
        mapLabels(codes, fields, plane);
}

void writeBarriers(DenseFields& fields, const core::BarrierListed& edit)
{
    forEachVoxel(fields.size(), [&](const glm::ivec3& voxel) {
        for (const core::BarrierListed::Brick& brick : edit.bricks) {
            if (int(brick.brick) == core::BrickGrid{fields.size()}.brickOf(voxel)
                && brick.places[std::size_t(core::BrickGrid::offsetInBrick(voxel))])
                setOrClearBarrier(fields, edit.plane, edit.erase, edit.lockedLabels, voxel);
        }
    });
}

void coverLabel(DenseFields& fields, const core::CoverLabel& edit)
{
    const DenseArray<std::uint8_t> labels = fields.labels(edit.plane);
    DenseArray<std::uint8_t>& coverage = fields.coverage(edit.layer);
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        const std::uint8_t held = labels.values[i];
        if (edit.outside ? held != edit.label && !edit.protectedLabels[held] : held == edit.label)
            coverage.values[i] = 255;
    }
}

void foldLayer(DenseFields& fields, const core::FoldLayer& edit)
{
    std::vector<std::uint8_t>& from = fields.coverage(edit.layer).values;
    if (edit.into) {
        std::vector<std::uint8_t>& into = fields.coverage(*edit.into).values;
        for (std::size_t i = 0; i < from.size(); ++i)
            into[i] = std::max(into[i], from[i]);
    }
    std::fill(from.begin(), from.end(), std::uint8_t(0));
}

} // namespace reference
