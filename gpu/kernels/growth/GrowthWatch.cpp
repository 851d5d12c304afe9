// SPDX-License-Identifier: Apache-2.0
// What a growth shows to its leak guard.
#include "core/growth/SeedWord.h"
#include "gpu/kernels/growth/GrowthKernel.h"

namespace gpu {

std::vector<core::LeakGuard::Voxel> GrowthKernel::listedFront() const
{
    std::vector<core::LeakGuard::Voxel> front;
    std::vector<std::uint32_t> entries(m_frontCount);
    if (entries.empty())
        return front;
    m_queues.read(std::span<std::uint32_t>(entries),
        std::size_t(m_frontQueue) * m_queueCapacity * sizeof(std::uint32_t));
    const BrickField& words = m_fields.seedWords(m_burst.plane);
    front.reserve(entries.size());
    for (const std::uint32_t entry : entries)
        front.push_back({.brick = words.ownerOf(entry >> 12), .offset = entry & 4095u});
    return front;
}

std::vector<core::LeakGuard::Voxel> GrowthKernel::frontInWords()
{
    std::vector<core::LeakGuard::Voxel> front;
    if (!m_guard)
        return front;
    const auto images = m_fields.copier().images(
        m_fields.textures(core::Field::SeedWords, m_burst.plane), m_lastTouched);
    for (std::size_t brick = 0; brick < images.size(); ++brick) {
        const std::vector<std::uint8_t>& bytes = images[brick];
        for (std::size_t i = 0; i < bytes.size(); i += 4) {
            const std::uint32_t word = std::uint32_t(bytes[i]) | std::uint32_t(bytes[i + 1]) << 8
                | std::uint32_t(bytes[i + 2]) << 16 | std::uint32_t(bytes[i + 3]) << 24;
            if (core::seedWord::isMember(word) && core::seedWord::generation(word) == m_generation)
                front.push_back({.brick = m_lastTouched[brick], .offset = std::uint32_t(i / 4)});
        }
    }
    return front;
}

void GrowthKernel::watch(const std::vector<core::LeakGuard::Voxel>& added)
{
    if (m_guard)
        m_alarm = m_guard->look(m_generation, added);
}

} // namespace gpu
