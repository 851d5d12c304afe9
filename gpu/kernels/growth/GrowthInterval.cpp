// SPDX-License-Identifier: Apache-2.0
// Opening a burst by what an interval changes (core::IntervalOpener) instead of by asking every
// voxel that has grown.
#include "core/growth/interval/IntervalOpener.h"
#include "gpu/fields/BrickImages.h"
#include "gpu/fields/bricks/BrickVoxels.h"
#include "gpu/gl/Gl.h"
#include "gpu/gl/SoftwareDriver.h"
#include "gpu/kernels/growth/GrowthKernel.h"

#include <algorithm>
#include <utility>

namespace gpu {

namespace {

/// With 8 bytes a voxel in memory, half a GiB.
constexpr std::size_t mostBricks = 16384;

std::vector<core::BrickKey> keysIn(
    core::Field field, std::uint8_t plane, std::span<const std::uint32_t> bricks)
{
    std::vector<core::BrickKey> keys;
    keys.reserve(bricks.size());
    for (const std::uint32_t brick : bricks)
        keys.push_back({.field = field, .plane = plane, .brick = brick});
    return keys;
}

std::vector<core::GrowthBrick> contentsOf(
    VoxelFields& fields, std::uint8_t plane, std::span<const std::uint32_t> bricks)
{
    auto words = readImages(fields, keysIn(core::Field::SeedWords, plane, bricks));
    auto labels = readImages(fields, keysIn(core::Field::Labels, plane, bricks));
    auto overwritten = readImages(fields, keysIn(core::Field::Overwritten, plane, bricks));
    auto codes = readCodes(fields.codes(), fields.grid(), bricks);
    std::vector<core::GrowthBrick> contents;
    contents.reserve(bricks.size());
    for (std::size_t i = 0; i < bricks.size(); ++i)
        contents.push_back({.words = std::move(words[i]),
            .labels = std::move(labels[i]),
            .overwritten = std::move(overwritten[i]),
            .codes = std::move(codes[i])});
    return contents;
}

} // namespace

bool opensByChange(const core::GrowBurst& burst)
{
    return core::IntervalOpener::suits(burst) && isSoftwareDriver();
}

std::unique_ptr<core::IntervalOpener> readGrowth(VoxelFields& fields, const core::GrowBurst& burst)
{
    const std::vector<std::uint32_t> held = fields.seedWords(burst.plane).heldBricks();
    if (held.size() > mostBricks)
        return nullptr;
    return core::IntervalOpener::prepare(
        burst, fields.grid(), held, [&](std::span<const std::uint32_t> bricks) {
            return contentsOf(fields, burst.plane, bricks);
        });
}

void GrowthKernel::open(core::IntervalOpener& opener)
{
    const core::OpenedInterval opened = opener.open(m_burst.lowCode, m_burst.highCode);
    writeChanges(opener.bricks().changes());
    m_generation = opened.kept;
    setOpenGeneration();
    if (!opened.admitted.empty()) {
        ++m_generation;
        m_frontSizes.push_back(std::uint32_t(opened.admitted.size()));
        m_members = m_frontSizes.back();
        watch(opened.admitted);
    }
    takeFront(opened);
}

void GrowthKernel::writeChanges(const std::vector<core::GrowthChange>& changes)
{
    if (changes.empty())
        return;
    std::vector<bool> isWritten(std::size_t(m_fields.grid().brickCount()), false);
    for (const core::GrowthChange& change : changes)
        isWritten[change.brick] = true;
    std::vector<std::uint32_t> written;
    for (std::uint32_t brick = 0; brick < isWritten.size(); ++brick) {
        if (isWritten[brick])
            written.push_back(brick);
    }
    capture(written);
    const std::shared_ptr<Program> program = m_programs.change(m_kind.overwritten);
    setUniforms(*program);
    program->set("changeCount", unsigned(changes.size()));
    start({});
    const Buffer list = bufferOf("growth changes", changes);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
    program->dispatch({unsigned(std::min<std::size_t>((changes.size() + 63) / 64, 4096)), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    (void)takeBatch();
}

/// As findFront() would find it.
void GrowthKernel::takeFront(const core::OpenedInterval& opened)
{
    m_frontBricks.clear();
    m_frontCount = std::uint32_t(opened.front.size());
    m_onlyLabel.reset();
    if (opened.front.empty())
        return;
    while (m_frontCount > m_queueCapacity)
        setQueues(4 * m_queueCapacity);
    const BrickField& words = m_fields.seedWords(m_burst.plane);
    std::vector<std::uint32_t> entries;
    entries.reserve(opened.front.size());
    for (const core::LeakGuard::Voxel voxel : opened.front) {
        if (m_frontBricks.empty() || m_frontBricks.back() != voxel.brick)
            m_frontBricks.push_back(voxel.brick);
        entries.push_back(words.pageOf(voxel.brick) << 12 | voxel.offset);
    }
    m_queues.write(std::span<const std::uint32_t>(entries),
        std::size_t(m_frontQueue) * m_queueCapacity * sizeof(std::uint32_t));
    m_onlyLabel = opened.label;
}

} // namespace gpu
