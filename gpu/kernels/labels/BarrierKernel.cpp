// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/labels/BarrierKernel.h"

#include "gpu/kernels/labels/ChosenBricks.h"

#include <algorithm>
#include <iterator>
#include <span>

namespace gpu {

namespace {

constexpr std::uint32_t changedLabel = 1; // barrierVoxel.glsl
constexpr std::uint32_t changedWord = 2;
constexpr std::uint32_t changedOverwritten = 4;
constexpr std::size_t bricksAtOnce = 1024;
constexpr std::size_t wordsPerBrick = core::BrickGrid::voxelsPerBrick / 32;

using Brick = core::BarrierListed::Brick;

std::vector<std::uint32_t> bitsOf(std::span<const Brick> bricks)
{
    std::vector<std::uint32_t> bits(bricks.size() * wordsPerBrick);
    for (std::size_t brick = 0; brick < bricks.size(); ++brick) {
        for (std::size_t place = 0; place < bricks[brick].places.size(); ++place) {
            if (bricks[brick].places[place])
                bits[brick * wordsPerBrick + place / 32] |= 1U << (place % 32);
        }
    }
    return bits;
}

/// Gives a page to those that have none. @return which they are
std::vector<std::uint32_t> ensure(BrickField& field, const std::vector<std::uint32_t>& bricks)
{
    std::vector<std::uint32_t> fresh;
    std::copy_if(bricks.begin(), bricks.end(), std::back_inserter(fresh),
        [&field](std::uint32_t brick) { return !field.holds(brick); });
    field.ensure(fresh);
    return fresh;
}

/// Runs a kernel whose textures are bound. @return what it says of each brick
std::vector<std::uint32_t> run(Program& kernel, const std::vector<std::uint32_t>& numbers,
    const std::vector<std::uint32_t>& places)
{
    std::vector<std::uint32_t> found(numbers.size(), 0);
    const Buffer list = bufferOf("barrier bricks", numbers);
    const Buffer changed = bufferOf("barriers found", found);
    const Buffer bits = bufferOf("barrier places", places);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    changed.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    bits.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    kernel.dispatch({unsigned(numbers.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    changed.read(std::span<std::uint32_t>(found));
    return found;
}

} // namespace

Program& BarrierPrograms::barrier(bool givesBack)
{
    Program& known = givesBack ? m_giving : m_plain;
    if (!known) {
        const char* path = "kernels/labels/barrierListed.comp";
        const ShaderDefines defines =
            givesBack ? ShaderDefines{{"OVERWRITTEN", 1}} : ShaderDefines{};
        known = Program(
            m_library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
    }
    return known;
}

std::vector<core::BrickKey> writeBarriers(BarrierPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::BarrierListed& edit)
{
    const bool givesBack = !edit.erase && fields.anyOverwritten(edit.plane);
    Program& kernel = programs.barrier(givesBack);
    kernel.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("erase", edit.erase)
        .set("lockedLabels", edit.lockedLabels);
    BrickField& words = fields.seedWords(edit.plane);
    std::vector<core::BrickKey> keys;
    const auto add = [&keys, &edit](core::Field field, const std::vector<std::uint32_t>& bricks) {
        for (const std::uint32_t brick : bricks)
            keys.push_back({.field = field, .plane = edit.plane, .brick = brick});
    };
    // Where no word is, no barrier is either.
    std::vector<Brick> listed;
    std::copy_if(edit.bricks.begin(), edit.bricks.end(), std::back_inserter(listed),
        [&](const Brick& each) { return !edit.erase || words.holds(each.brick); });
    for (std::size_t first = 0; first < listed.size(); first += bricksAtOnce) {
        const std::span<const Brick> batch(
            listed.data() + first, std::min(bricksAtOnce, listed.size() - first));
        std::vector<std::uint32_t> numbers;
        for (const Brick& brick : batch)
            numbers.push_back(brick.brick);
        before.capture(core::Field::Labels, edit.plane, numbers);
        before.capture(core::Field::SeedWords, edit.plane, numbers);
        if (givesBack)
            before.capture(core::Field::Overwritten, edit.plane, numbers);
        const std::vector<std::uint32_t> fresh = ensure(words, numbers);
        if (givesBack) {
            BrickField& overwritten = fields.overwritten(edit.plane);
            overwritten.pageTable().bindUnit(2);
            overwritten.atlas().bindImage(2, GL_READ_WRITE);
        }
        words.pageTable().bindUnit(1);
        fields.labels(edit.plane).bindImage(0, GL_READ_WRITE);
        words.atlas().bindImage(1, GL_READ_WRITE);
        const std::vector<std::uint32_t> found = run(kernel, numbers, bitsOf(batch));

        const std::vector<std::uint32_t> labels = chosen(numbers, found, changedLabel);
        const std::vector<std::uint32_t> changed = chosen(numbers, found, changedWord);
        std::vector<std::uint32_t> unused;
        std::set_difference(
            fresh.begin(), fresh.end(), changed.begin(), changed.end(), std::back_inserter(unused));
        words.release(unused);
        fields.noteChanged(core::Field::Labels, labels);
        fields.noteChanged(core::Field::SeedWords, changed);
        add(core::Field::Labels, labels);
        add(core::Field::SeedWords, changed);
        add(core::Field::Overwritten, chosen(numbers, found, changedOverwritten));
    }
    return keys;
}

} // namespace gpu
