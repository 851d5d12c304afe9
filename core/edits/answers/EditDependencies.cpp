// SPDX-License-Identifier: Apache-2.0
#include "core/edits/answers/EditDependencies.h"

#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/EditableRange.h"

namespace core {

namespace {

std::set<std::uint32_t> bricksUnder(
    const BrushPath& path, const CapsuleFrame& frame, const VolumeGeometry& geometry)
{
    std::set<std::uint32_t> under;
    for (const Capsule& capsule : capsules(path, geometry)) {
        const std::vector<std::uint32_t> near =
            bricksNear(frame, capsule, BrickGrid{geometry.size});
        under.insert(near.begin(), near.end());
    }
    return under;
}

} // namespace

const VolumeGeometry& DependencyFacts::geometry() const
{
    return document.volumes.front().geometry;
}

BrickGrid DependencyFacts::grid() const
{
    return BrickGrid{geometry().size};
}

std::uint8_t DependencyFacts::planeOf(int label) const
{
    const Segment* segment = document.segment(label);
    return segment ? segment->plane : std::uint8_t(0);
}

EditDependencies DependencyFacts::whatWasWritten() const
{
    return dependsOn::Bricks{{written.begin(), written.end()}};
}

std::set<std::uint32_t> DependencyFacts::under(const BrushPath& path) const
{
    const auto frame = capsuleFrame(path, geometry(), {});
    return frame ? bricksUnder(path, *frame, geometry()) : std::set<std::uint32_t>();
}

EditDependencies DependencyFacts::labelled(
    const std::set<std::uint32_t>& bricks, std::uint8_t plane) const
{
    dependsOn::Bricks stored;
    for (const std::uint32_t brick : bricks) {
        for (const Field field : {Field::Labels, Field::SeedWords, Field::Overwritten})
            stored.keys.insert({field, plane, brick});
    }
    return stored;
}

EditDependencies DependencyFacts::labelled(const BrushPath& path, std::uint8_t plane) const
{
    return labelled(under(path), plane);
}

EditDependencies DependencyFacts::alsoReading(
    const std::optional<EditableRange>& range, EditDependencies own) const
{
    if (!range)
        return own;
    std::bitset<256> planes;
    for (const auto* listed : {&range->inside, &range->outside}) {
        for (const int label : listed->value_or(std::vector<int>()))
            planes.set(planeOf(label));
    }
    dependsOn::Any& any = own;
    auto* const bricks = std::get_if<dependsOn::Bricks>(&any);
    if (!bricks) {
        own.labelPlanes |= planes;
        return own;
    }
    std::set<std::uint32_t> numbers;
    for (const BrickKey& key : bricks->keys)
        numbers.insert(key.brick);
    for (std::size_t plane = 0; plane < planes.size(); ++plane) {
        for (const std::uint32_t brick : numbers) {
            if (planes.test(plane))
                bricks->keys.insert({Field::Labels, std::uint8_t(plane), brick});
        }
    }
    return own;
}

} // namespace core
