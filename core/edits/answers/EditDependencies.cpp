// SPDX-License-Identifier: Apache-2.0
#include "core/edits/answers/EditDependencies.h"

#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/parts/BrushPath.h"

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

std::uint8_t DependencyFacts::growthPlane() const
{
    return document.growths.front().plane;
}

EditDependencies DependencyFacts::whatWasWritten() const
{
    return dependsOn::Bricks{{written.begin(), written.end()}};
}

EditDependencies DependencyFacts::wholeGrowth() const
{
    return dependsOn::Plane{growthPlane()};
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

} // namespace core
