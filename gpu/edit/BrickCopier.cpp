// SPDX-License-Identifier: Apache-2.0
#include "gpu/edit/BrickCopier.h"

#include <algorithm>
#include <cstring>
#include <memory>

namespace gpu {

namespace {

Program program(const ShaderLibrary& library, const char* path, const ShaderDefines& defines)
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
}

Buffer brickList(std::span<const std::uint32_t> bricks)
{
    Buffer list({.label = "brick list", .bytes = bricks.size_bytes()});
    list.write(bricks);
    return list;
}

constexpr std::size_t bricksPerReadback = 1024;

/// Whether all bytes are the same one: every byte equals the one after it.
bool isEmpty(std::span<const std::uint8_t> image, std::uint8_t emptyByte)
{
    return image.front() == emptyByte
        && std::memcmp(image.data(), image.data() + 1, image.size() - 1) == 0;
}

} // namespace

std::size_t packedBrickBytes(core::Field field)
{
    return std::size_t(core::BrickGrid::voxelsPerBrick) * std::size_t(core::bytesPerVoxel(field));
}

BrickCopier::BrickCopier(const ShaderLibrary& library, const core::BrickGrid& grid)
    : m_grid(grid)
    , m_packDense(program(library, "edit/packBricks.comp", {{"FIELD_DENSE", 1}}))
    , m_packBytes(program(library, "edit/packBricks.comp", {}))
    , m_packWords(program(library, "edit/packBricks.comp", {{"FIELD_WORDS", 1}}))
    , m_unpackDense(program(library, "edit/unpackBricks.comp", {{"FIELD_DENSE", 1}}))
    , m_unpackBytes(program(library, "edit/unpackBricks.comp", {}))
    , m_unpackWords(program(library, "edit/unpackBricks.comp", {{"FIELD_WORDS", 1}}))
{
    for (Program* each :
        {&m_packDense, &m_packBytes, &m_packWords, &m_unpackDense, &m_unpackBytes, &m_unpackWords})
        each->set("volumeSize", grid.volumeSize).set("volumeBricks", grid.bricks());
    m_packBytes.set("emptyVoxel", 0u);
    m_packWords.set("emptyVoxel", 0xFFFFFFFFu);
}

Buffer BrickCopier::packed(const FieldTextures& source, std::span<const std::uint32_t> bricks) const
{
    Buffer target(
        {.label = "packed bricks", .bytes = packedBrickBytes(source.field) * bricks.size()});
    const Program& pack = !source.pageTable      ? m_packDense
        : source.field == core::Field::SeedWords ? m_packWords
                                                 : m_packBytes;
    const Buffer list = brickList(bricks);
    source.voxels->bindUnit(0);
    if (source.pageTable)
        source.pageTable->bindUnit(1);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    target.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    pack.dispatch({unsigned(bricks.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
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
    for (std::size_t first = 0; first < bricks.size(); first += bricksPerReadback) {
        const auto piece =
            bricks.subspan(first, std::min(bricksPerReadback, bricks.size() - first));
        std::vector<std::uint8_t> staging(piece.size() * bytes, core::emptyByte(target.field));
        for (std::size_t i = 0; i < piece.size(); ++i) {
            if (!images[first + i]->empty())
                std::memcpy(&staging[i * bytes], images[first + i]->data(), bytes);
        }
        Buffer packed({.label = "bricks to write", .bytes = staging.size()});
        packed.write(std::span<const std::uint8_t>(staging));
        write(target, piece, packed);
    }
}

void BrickCopier::write(
    const FieldTextures& target, std::span<const std::uint32_t> bricks, const Buffer& packed) const
{
    const Program& unpack = !target.pageTable    ? m_unpackDense
        : target.field == core::Field::SeedWords ? m_unpackWords
                                                 : m_unpackBytes;
    const Buffer list = brickList(bricks);
    target.voxels->bindImage(0, GL_WRITE_ONLY);
    if (target.pageTable)
        target.pageTable->bindUnit(1);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    packed.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    unpack.dispatch({unsigned(bricks.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace gpu
