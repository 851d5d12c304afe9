// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/ReferenceEngine.h"

#include "tests/reference/Oracle.h"

#include <utility>

namespace reference {

ReferenceEngine::ReferenceEngine()
    : m_oracle(std::make_unique<Oracle>())
{
}

ReferenceEngine::~ReferenceEngine() = default;

core::Result<void> ReferenceEngine::openVolume(
    const glm::ivec3& size, std::span<const std::uint16_t> codes)
{
    return m_oracle->openVolume(size, codes);
}

core::Ticket ReferenceEngine::submit(core::EngineCommand command)
{
    return m_oracle->submit(std::move(command));
}

std::vector<core::EngineResult> ReferenceEngine::collect()
{
    return m_oracle->collect();
}

void ReferenceEngine::setWakeUp(std::function<void()> wakeUp)
{
    m_oracle->setWakeUp(std::move(wakeUp));
}

core::GrowthProgress ReferenceEngine::growthProgress() const
{
    return m_oracle->growthProgress();
}

const DenseFields& ReferenceEngine::fields() const
{
    return m_oracle->fields();
}

DenseArray<std::uint8_t> ReferenceEngine::carved() const
{
    return m_oracle->carved();
}

} // namespace reference
