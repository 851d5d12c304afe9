// SPDX-License-Identifier: Apache-2.0
#include "core/session/surface/SurfaceStep.h"

#include "core/delta/DeltaStream.h"
#include "core/refine/mesh/SurfaceDelta.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace core {

namespace {

constexpr std::size_t hashDigits = 64;
constexpr std::size_t mostMeshBytes = std::size_t(1) << 30;

void add(DeltaWriter& writer, std::uint32_t number)
{
    std::array<std::uint8_t, 4> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = std::uint8_t(number >> (8 * i));
    writer.add(bytes);
}

void addBlock(DeltaWriter& writer, const QByteArray& bytes)
{
    add(writer, std::uint32_t(bytes.size()));
    writer.add(bytes);
}

void add(DeltaWriter& writer, const SurfaceStep::Target& target)
{
    addBlock(writer, packedRuns(target.voxels));
    const auto bits = std::bit_cast<std::uint64_t>(target.faceAreaMm2);
    add(writer, std::uint32_t(bits));
    add(writer, std::uint32_t(bits >> 32));
}

tl::unexpected<Error> damaged()
{
    return failure(ErrorCode::SessionDamaged,
        Clause::saying("what changed of the surface is cut short or garbled"));
}

std::optional<std::uint32_t> takeNumber(DeltaReader& reader)
{
    std::array<std::uint8_t, 4> bytes{};
    if (!reader.fill(bytes))
        return std::nullopt;
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        number |= std::uint32_t(bytes[i]) << (8 * i);
    return number;
}

/// Grows with what is there, so that a false size takes no memory.
std::optional<QByteArray> takeBlock(DeltaReader& reader, std::size_t most)
{
    const std::optional<std::uint32_t> size = takeNumber(reader);
    if (!size || *size > most)
        return std::nullopt;
    constexpr std::size_t portion = std::size_t(1) << 20;
    QByteArray bytes;
    while (std::size_t(bytes.size()) < *size) {
        QByteArray part(qsizetype(std::min(portion, *size - std::size_t(bytes.size()))), '\0');
        if (reader.take(part.data(), std::size_t(part.size())) != std::size_t(part.size()))
            return std::nullopt;
        bytes += part;
    }
    return bytes;
}

std::optional<SurfaceStep::Target> takeTarget(DeltaReader& reader, std::uint64_t voxels)
{
    const std::optional<QByteArray> bytes = takeBlock(reader, std::size_t(mostPackedRunBytes));
    std::optional<VoxelRuns> runs = bytes ? unpackedRuns(*bytes, voxels) : std::nullopt;
    const std::optional<std::uint32_t> low = runs ? takeNumber(reader) : std::nullopt;
    const std::optional<std::uint32_t> high = low ? takeNumber(reader) : std::nullopt;
    if (!high)
        return std::nullopt;
    const double area = std::bit_cast<double>(std::uint64_t(*high) << 32 | *low);
    if (!std::isfinite(area) || area < 0.0)
        return std::nullopt;
    return SurfaceStep::Target{.voxels = *std::move(runs), .faceAreaMm2 = area};
}

bool isHash(const QByteArray& text)
{
    return text.isEmpty() || text.size() == qsizetype(hashDigits);
}

} // namespace

BrickDelta packed(const SurfaceStep& step)
{
    DeltaWriter writer;
    writer.add(surfaceStepMagic);
    addBlock(writer, step.sha256Before);
    addBlock(writer, step.sha256After);
    add(writer, step.target ? 1 : 0);
    if (step.target) {
        add(writer, step.target->before);
        add(writer, step.target->after);
    }
    addBlock(writer, packed(step.mesh));
    return {writer.finish()};
}

Result<SurfaceStep> unpackedSurfaceStep(const BrickDelta& delta, std::uint64_t voxels)
{
    DeltaReader reader(delta);
    std::array<char, surfaceStepMagic.size()> magic{};
    if (!reader.fill(magic) || magic != surfaceStepMagic)
        return damaged();
    const std::optional<QByteArray> before = takeBlock(reader, hashDigits);
    const std::optional<QByteArray> after = before ? takeBlock(reader, hashDigits) : std::nullopt;
    const std::optional<std::uint32_t> hasTarget = after ? takeNumber(reader) : std::nullopt;
    if (!hasTarget || *hasTarget > 1 || !isHash(*before) || !isHash(*after))
        return damaged();
    SurfaceStep step{.sha256Before = *before, .sha256After = *after};
    if (*hasTarget == 1) {
        std::optional<SurfaceStep::Target> from = takeTarget(reader, voxels);
        std::optional<SurfaceStep::Target> to = from ? takeTarget(reader, voxels) : std::nullopt;
        if (!to)
            return damaged();
        step.target = {.before = *std::move(from), .after = *std::move(to)};
    }
    const std::optional<QByteArray> mesh = takeBlock(reader, mostMeshBytes);
    if (!mesh || !reader.complete())
        return damaged();
    Result<SimplexMeshDelta> unpacked = unpackedSurfaceDelta(*mesh);
    if (!unpacked)
        return damaged();
    step.mesh = *std::move(unpacked);
    return step;
}

} // namespace core
