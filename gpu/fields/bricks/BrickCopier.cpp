// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/bricks/BrickCopier.h"

#include "gpu/fields/bricks/BrickVoxels.h"
#include "gpu/gl/GlFailure.h"

#include <algorithm>
#include <cstring>
#include <memory>

namespace gpu {

namespace {

Buffer brickList(std::span<const std::uint32_t> bricks)
{
    Buffer list({.label = "brick list", .bytes = bricks.size_bytes()});
    list.write(bricks);
    return list;
}

constexpr std::size_t bricksPerReadback = 1024;
// Storage blocks end at 128 MiB, which is as much of seed words. Ranges of the lists begin at
// multiples of what any driver asks for.
constexpr std::size_t bricksPerDispatch = 8192;

/// Runs a kernel whose textures are bound over listed bricks and their packed voxels.
void run(const Program& kernel, std::span<const std::uint32_t> bricks, const Buffer& packed,
    core::Field field)
{
    const Buffer list = brickList(bricks);
    const std::size_t bytes = packedBrickBytes(field);
    for (std::size_t first = 0; first < bricks.size(); first += bricksPerDispatch) {
        const std::size_t count = std::min(bricksPerDispatch, bricks.size() - first);
        list.bindRange(GL_SHADER_STORAGE_BUFFER, 0, first * sizeof(std::uint32_t),
            count * sizeof(std::uint32_t));
        packed.bindRange(GL_SHADER_STORAGE_BUFFER, 1, first * bytes, count * bytes);
        kernel.dispatch({unsigned(count), 1, 1});
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

/// Whether all bytes are the same one: every byte equals the one after it.
bool isEmpty(std::span<const std::uint8_t> image, std::uint8_t emptyByte)
{
    return image.front() == emptyByte
        && std::memcmp(image.data(), image.data() + 1, image.size() - 1) == 0;
}

} // namespace

FieldTextures texturesOf(BrickField& pages, core::Field field)
{
    return {
        .voxels = &pages.atlas(), .pageTable = &pages.pageTable(), .pages = &pages, .field = field};
}

std::size_t packedBrickBytes(core::Field field)
{
    return std::size_t(core::BrickGrid::voxelsPerBrick) * std::size_t(core::bytesPerVoxel(field));
}

BrickCopier::BrickCopier(CopyPrograms& programs, const core::BrickGrid& grid, WorkBy by)
    : m_grid(grid)
    , m_programs(programs)
    , m_byProcessor(isByProcessor(by))
{
}

void BrickCopier::read(
    const FieldTextures& source, std::uint32_t brick, std::span<std::uint8_t> image) const
{
    if (!source.pages)
        readDense(*source.voxels, m_grid, brick, image);
    else if (source.pages->holds(brick))
        source.pages->read(brick, std::as_writable_bytes(image));
    else
        std::fill(image.begin(), image.end(), core::emptyByte(source.field));
}

void BrickCopier::write(
    const FieldTextures& target, std::uint32_t brick, std::span<const std::uint8_t> image) const
{
    if (target.pages)
        target.pages->write(brick, std::as_bytes(image));
    else
        writeDense(*target.voxels, m_grid, brick, image);
}

Buffer BrickCopier::packed(const FieldTextures& source, std::span<const std::uint32_t> bricks) const
{
    Buffer target(
        {.label = "packed bricks", .bytes = packedBrickBytes(source.field) * bricks.size()});
    if (m_byProcessor) {
        std::vector<std::uint8_t> image(packedBrickBytes(source.field));
        for (std::size_t i = 0; i < bricks.size(); ++i) {
            read(source, bricks[i], image);
            target.write(std::span<const std::uint8_t>(image), i * image.size());
        }
        requireNoError(); // as below
        return target;
    }
    Program& pack = !source.pageTable            ? m_programs.packDense
        : source.field == core::Field::SeedWords ? m_programs.packWords
                                                 : m_programs.packBytes;
    pack.set("volumeSize", m_grid.volumeSize).set("volumeBricks", m_grid.bricks());
    source.voxels->bindUnit(0);
    if (source.pageTable)
        source.pageTable->bindUnit(1);
    run(pack, bricks, target, source.field);
    requireNoError(); // what was not packed must never be put back
    return target;
}

std::vector<std::vector<std::uint8_t>> BrickCopier::images(
    const Buffer& packed, core::Field field, std::size_t count)
{
    const std::size_t bytes = packedBrickBytes(field);
    const auto staging = std::make_unique_for_overwrite<std::uint8_t[]>(count * bytes);
    packed.read(std::span<std::uint8_t>(staging.get(), count * bytes));
    std::vector<std::vector<std::uint8_t>> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::span<const std::uint8_t> image(staging.get() + i * bytes, bytes);
        if (!isEmpty(image, core::emptyByte(field)))
            result[i].assign(image.begin(), image.end());
    }
    return result;
}

std::vector<std::vector<std::uint8_t>> BrickCopier::images(
    const FieldTextures& source, std::span<const std::uint32_t> bricks) const
{
    std::vector<std::vector<std::uint8_t>> result;
    if (m_byProcessor) {
        std::vector<std::uint8_t> image(packedBrickBytes(source.field));
        result.resize(bricks.size());
        for (std::size_t i = 0; i < bricks.size(); ++i) {
            read(source, bricks[i], image);
            if (!isEmpty(image, core::emptyByte(source.field)))
                result[i] = image;
        }
        requireNoError();
        return result;
    }
    for (std::size_t first = 0; first < bricks.size(); first += bricksPerReadback) {
        const auto piece =
            bricks.subspan(first, std::min(bricksPerReadback, bricks.size() - first));
        for (auto& image : images(packed(source, piece), source.field, piece.size()))
            result.push_back(std::move(image));
    }
    return result;
}

void BrickCopier::write(const FieldTextures& target, std::span<const std::uint32_t> bricks,
    std::span<const std::vector<std::uint8_t>* const> images) const
{
    const std::size_t bytes = packedBrickBytes(target.field);
    if (m_byProcessor) {
        const std::vector<std::uint8_t> empty(bytes, core::emptyByte(target.field));
        for (std::size_t i = 0; i < bricks.size(); ++i)
            write(target, bricks[i], images[i]->empty() ? empty : *images[i]);
        return;
    }
    for (std::size_t first = 0; first < bricks.size(); first += bricksPerReadback) {
        const auto piece =
            bricks.subspan(first, std::min(bricksPerReadback, bricks.size() - first));
        const std::size_t size = piece.size() * bytes;
        const auto staging = std::make_unique_for_overwrite<std::uint8_t[]>(size);
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const std::vector<std::uint8_t>& image = *images[first + i];
            if (image.empty())
                std::memset(staging.get() + i * bytes, core::emptyByte(target.field), bytes);
            else
                std::memcpy(staging.get() + i * bytes, image.data(), bytes);
        }
        Buffer packed({.label = "bricks to write", .bytes = size});
        packed.write(std::span<const std::uint8_t>(staging.get(), size));
        write(target, piece, packed);
    }
}

void BrickCopier::write(
    const FieldTextures& target, std::span<const std::uint32_t> bricks, const Buffer& packed) const
{
    if (m_byProcessor) {
        std::vector<std::uint8_t> image(packedBrickBytes(target.field));
        for (std::size_t i = 0; i < bricks.size(); ++i) {
            if (bricks[i] == skipped)
                continue;
            packed.read(std::span<std::uint8_t>(image), i * image.size());
            write(target, bricks[i], image);
        }
        return;
    }
    Program& unpack = !target.pageTable          ? m_programs.unpackDense
        : target.field == core::Field::SeedWords ? m_programs.unpackWords
                                                 : m_programs.unpackBytes;
    unpack.set("volumeSize", m_grid.volumeSize).set("volumeBricks", m_grid.bricks());
    target.voxels->bindImage(0, GL_WRITE_ONLY);
    if (target.pageTable)
        target.pageTable->bindUnit(1);
    run(unpack, bricks, packed, target.field);
}

} // namespace gpu
